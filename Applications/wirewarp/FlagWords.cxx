// SPDX-License-Identifier: BSD-3-Clause
#include "FlagWords.h"

namespace wirewarp
{
namespace
{
/// Those that name an option. The filters' words serve for the others.
constexpr RemedyPhrases phrases{
  { "WriteAgain", "write the file again" },
  { "SkipClosed", "leave out what cannot be laid flat (--skip-closed)" },
  { "OuterSide", "take one side of a sheet with thickness (--outer-side)" },
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
  { "AllowSewingIterations", "raise --resew-iterations" },
  { "TestPanels", "use --resew panel" },
  { "AllowLengthError", "raise --max-length-error" },
  { "CloseCuts", "close the cuts as far as they cross (--close-cuts)" },
  { "NameGrain", "name a curve of the piece with --grain: %" },
  { "GiveGrainAngle", "give degrees or \"free\" (--grain)" },
  { "TakeSofterCloth", "take a material that gives more (--material)" },
  { "CheckUnit", "check the unit (--unit)" },
  { "WidenNotches", "raise --notch-spacing" },
  { "PrintOnPages", "print on several pages (--paper A4, letter, A3 or A0)" },
  { "TakeLargerPaper", "take larger paper (--paper)" },
  { "WriteOtherFormat", "write --svg or --dxf" },
  { "NameAnotherFile", "name another folder with --output" },
};
}

//------------------------------------------------------------------------------
std::string remedyWords(const std::string& name)
{
  return phraseOf(phrases, name);
}

//------------------------------------------------------------------------------
std::string messageOf(const std::string& defect, const std::vector<Remedy>& remedies)
{
  return describe(defect, remedies, phrases);
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
