// SPDX-License-Identifier: BSD-3-Clause
#include "FlagWords.h"

namespace wirewarp
{
namespace
{
/// Where an option is not the property's name.
constexpr SpellingTable table{
  { "ConformalPins", "--pins" },
  { "CurveTolerances", "--tolerance" },
  { "CurveType", "in the curves' file" },
  { "Interior=AS_RIGID_AS_POSSIBLE", "--interior arap" },
  { "IsometricMaximumIterations", "--isometric-iterations" },
  { "LengthTolerance", "--tolerance" },
  { "RigidMaximumIterations", "--rigid-iterations" },
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
  for (const char c : property)
  {
    const bool capital = c >= 'A' && c <= 'Z';
    flag += capital ? std::string(flag.empty() ? "--" : "-") + static_cast<char>(c - 'A' + 'a')
                    : std::string(1, c);
  }
  for (const char* const word : { "maximum", "minimum" })
  {
    const std::size_t at = flag.find(word);
    flag = at == std::string::npos ? flag : flag.erase(at + 3, 4);
  }
  flag += value.empty() || value == "on" ? "" : " ";
  for (const char c : value == "on" ? std::string() : value)
  {
    flag += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return flag;
}
}

//------------------------------------------------------------------------------
std::string remedyWords(const std::string& name)
{
  return remedyWords(name, flagOf);
}

//------------------------------------------------------------------------------
std::string messageOf(const std::string& defect, const std::vector<Remedy>& remedies)
{
  return describe(defect, remedies, flagOf);
}

//------------------------------------------------------------------------------
std::vector<Remedy> remediesOf(const FieldRows& field, vtkIdType piece)
{
  std::vector<Remedy> remedies;
  for (vtkIdType row = 0; row < field.count("RemedyPiece"); ++row)
  {
    if (field.integer("RemedyPiece", row) == piece)
    {
      remedies.push_back({ field.text("RemedyName", row), field.text("RemedySubject", row) });
    }
  }
  return remedies;
}
}
