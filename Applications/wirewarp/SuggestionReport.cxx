// SPDX-License-Identifier: BSD-3-Clause
#include "SuggestionReport.h"

#include "FieldRows.h"
#include "Report.h"
#include "SuggestedCuts.h"

namespace wirewarp
{
namespace
{
using Json = nlohmann::ordered_json;

Json suggestionReport(const SuggestedCut& cut)
{
  return { { "type", curveTypeName(cut.type) }, { "name", cut.name }, { "length", cut.length },
    { "gain", cut.gain }, { "E_area_before", cut.areaErrorBefore },
    { "E_area_after", cut.areaErrorAfter }, { "strain_p95_before", cut.strainBefore },
    { "strain_p95_after", cut.strainAfter } };
}

/// Some numbers of an array.
Json numbers(const FieldRows& field, const char* array, vtkIdType first, vtkIdType count)
{
  Json list = Json::array();
  for (vtkIdType k = first; k < first + count; ++k)
  {
    list.push_back(field.number(array, k));
  }
  return list;
}
}

//------------------------------------------------------------------------------
Json suggestionReports(const Flattening& result)
{
  Json suggestions = Json::array();
  for (const SuggestedCut& cut : suggestedCuts(result))
  {
    Json row = suggestionReport(cut);
    row["gain_predicted"] = cut.predictedGain;
    row["opening"] = cut.opening;
    row["mirror_of"] = cut.mirrorOf;
    suggestions.push_back(std::move(row));
  }
  return suggestions;
}

//------------------------------------------------------------------------------
Json leftOutLineReports(const Flattening& result)
{
  Json lines = Json::array();
  for (const LeftOutLine& line : leftOutLines(result))
  {
    Json row = suggestionReport(line);
    row["sound"] = line.sound;
    lines.push_back(std::move(row));
  }
  return lines;
}

//------------------------------------------------------------------------------
Json mirrorReport(const Flattening& result)
{
  const FieldRows field(result.curves);
  if (field.count("MirrorPlane") > 0)
  {
    return { { "type", "plane" }, { "normal", numbers(field, "MirrorPlane", 0, 3) },
      { "offset", field.number("MirrorPlane", 3) } };
  }
  if (field.count("MirrorAxis") > 0)
  {
    return { { "type", "axis" },
      { "ends",
        Json::array({ numbers(field, "MirrorAxis", 0, 3), numbers(field, "MirrorAxis", 3, 3) }) } };
  }
  return nullptr;
}
}
