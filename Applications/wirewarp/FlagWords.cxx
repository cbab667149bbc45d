// SPDX-License-Identifier: BSD-3-Clause
#include "FlagWords.h"

#include "Options/OptionTable.h"

namespace wirewarp
{
namespace
{
/// Where a remedy is not an option of the table.
constexpr SpellingTable table{
  { "CurveType", "in the curves' file" },
  { "Interior=AS_RIGID_AS_POSSIBLE", "--interior arap" },
  { "LengthTolerance", "--tolerance" },
  { "Sewing.MaximumIterations", "--sewing-iterations" },
  { "Sewing.Test", "--mode panel" },
  { "SplitTriangles", "leave out --no-split-triangles" },
  { "vtkFeatureCurveSuggestion", "wirewarp cut" },
};

/// MaximumLengthError is --max-length-error.
std::string flagOf(const std::string& property, const std::string& value)
{
  std::string flag = findSpelling(table, property, value);
  if (!flag.empty())
  {
    return flag;
  }
  const flattening::Option* const option =
    findOption(flattening::OptionOwner::Suggestion, property);
  flag = option ? spelled(*option, flattening::OptionSpelling::Command)
                : "--" + flattening::spellingOf(property);
  flag += value.empty() || value == "on" ? "" : " ";
  for (const char c : value == "on" ? std::string() : value)
  {
    flag += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return flag;
}
}

std::string remedyWords(const std::string& name)
{
  return remedyWords(name, flagOf);
}

std::string messageOf(const std::string& defect, const std::vector<Remedy>& remedies)
{
  return describe(defect, remedies, flagOf);
}
}
