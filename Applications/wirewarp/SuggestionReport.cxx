// SPDX-License-Identifier: BSD-3-Clause
#include "SuggestionReport.h"

#include "SuggestedCuts.h"

namespace wirewarp
{
namespace
{
using Json = nlohmann::ordered_json;

Json suggestionReport(const SuggestedCut& cut)
{
  return { { "type", cut.type }, { "name", cut.name }, { "length", cut.length },
    { "gain", cut.gain }, { "E_area_before", cut.areaErrorBefore },
    { "E_area_after", cut.areaErrorAfter }, { "strain_p95_before", cut.strainBefore },
    { "strain_p95_after", cut.strainAfter } };
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
  const std::vector<double> plane = mirrorNumbers(result, "MirrorPlane");
  const std::vector<double> axis = mirrorNumbers(result, "MirrorAxis");
  if (!plane.empty())
  {
    return { { "type", "plane" }, { "normal", Json::array({ plane[0], plane[1], plane[2] }) },
      { "offset", plane[3] } };
  }
  if (!axis.empty())
  {
    return { { "type", "axis" },
      { "ends",
        Json::array({ Json::array({ axis[0], axis[1], axis[2] }),
          Json::array({ axis[3], axis[4], axis[5] }) }) } };
  }
  return nullptr;
}
}
