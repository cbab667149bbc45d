// SPDX-License-Identifier: BSD-3-Clause
#include "FlagWords.h"

#include "Options/OptionValues.h"

#include <map>

namespace wirewarp
{
namespace
{
std::string flagOf(const std::string& property, const std::string& value)
{
  // Where a remedy is not an option of the table, or the flag turns it off.
  static const std::map<std::string, std::string> others{ { "CurveType", "in the curves' file" },
    { "LengthTolerance", "--tolerance" }, { "SplitTriangles", "leave out --no-split-triangles" },
    { "vtkFeatureCurveSuggestion", "wirewarp cut" } };
  const auto found = others.find(property);
  return found == others.end()
    ? spelledSetting(property, value, flattening::OptionSpelling::Command)
    : found->second;
}
}

std::string remedyWords(const std::string& name)
{
  return flattening::remedyWords(name, flagOf);
}

std::string messageOf(const std::string& defect, const std::vector<Remedy>& remedies)
{
  return describeDefect(defect, remedies, flagOf);
}
}
