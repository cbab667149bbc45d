// SPDX-License-Identifier: BSD-3-Clause
#include "FlagWords.h"

#include <vtkFlatteningAlgorithm.h>
#include <vtkStringArray.h>

#include <array>

namespace wirewarp
{
namespace
{
struct Words
{
  const char* remedy;
  const char* words;
};

/// Those that name an option. The filters' words serve for the others.
constexpr std::array<Words, 20> words{ {
  { "WriteAgain", "write the file again" },
  { "SkipClosed", "leave out what cannot be laid flat (--skip-closed)" },
  { "DivideInput", "divide the file" },
  { "RaiseImprintTolerance", "raise --imprint-tolerance to %" },
  { "SplitTriangles", "leave out --no-split" },
  { "RaiseSnapTolerance", "raise --snap-tolerance" },
  { "NameCurve", "name one of the curves for --tolerance" },
  { "NamePins", "name two points of the surface with --pins, or leave it out" },
  { "OrderRelaxation",
    "give --relaxation-min-iterations <= --relaxation-max-iterations, of them one at least, and a "
    "--relaxation-movement that is not negative" },
  { "AllowAngleIterations", "raise --max-iterations" },
  { "AllowIsometricIterations", "raise --isometric-iterations" },
  { "AllowRigidIterations", "raise --rigid-iterations" },
  { "AllowRelaxationIterations",
    "raise --relaxation-max-iterations or --relaxation-movement, or use --interior laplacian" },
  { "UseNewton", "use --solver newton" },
  { "UseIsometricScheme", "use --scheme isometric" },
  { "UseRigidInterior", "use --interior arap" },
  { "ReleaseCurves", "remove % or make it elastic (--tolerance)" },
  { "MakeAccessory",
    "turn % into accessory curves (in the curves' file, or --release-keys for all keys)" },
  { "AllowLengthError", "raise --max-length-error" },
  { "CloseCuts", "close the cuts as far as they cross (--close-cuts)" },
} };
}

//------------------------------------------------------------------------------
std::string remedyWords(const std::string& name)
{
  for (const Words& entry : words)
  {
    if (name == entry.remedy)
    {
      return entry.words;
    }
  }
  const char* const filters = vtkFlatteningAlgorithm::GetRemedyWords(name.c_str());
  return filters ? filters : "";
}

//------------------------------------------------------------------------------
std::string messageOf(const std::string& defect, const std::vector<Remedy>& remedies)
{
  std::string text = defect;
  const char* join = "; ";
  for (const Remedy& remedy : remedies)
  {
    std::string way = remedyWords(remedy.name);
    const std::size_t at = way.find('%');
    text += join + (at == std::string::npos ? way : way.replace(at, 1, remedy.subject));
    join = ", or ";
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<Remedy> remediesOf(const vtkFlatteningAlgorithm* filter)
{
  std::vector<Remedy> remedies;
  vtkStringArray* const names = filter->GetStatusRemedies();
  for (vtkIdType k = 0; k < names->GetNumberOfValues(); ++k)
  {
    remedies.push_back({ names->GetValue(k), filter->GetStatusRemedySubjects()->GetValue(k) });
  }
  return remedies;
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
