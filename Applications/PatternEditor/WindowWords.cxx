// SPDX-License-Identifier: BSD-3-Clause
#include "WindowWords.h"

#include "RemedyPhrases.h"

#include <vtkFlatteningAlgorithm.h>
#include <vtkNew.h>
#include <vtkPatternWriter.h>

namespace editor
{
namespace
{
/// Those that the filters say with properties. Nothing in the window sets the ones without words.
constexpr wirewarp::RemedyPhrases phrases{
  { "WriteAgain", "write the file again" },
  { "SkipClosed", "" },
  { "DivideInput", "divide the surface" },
  { "RaiseImprintTolerance", "draw the curve again here" },
  { "SplitTriangles", "" },
  { "RaiseSnapTolerance", "" },
  { "NameCurve", "" },
  { "NamePins", "" },
  { "OrderRelaxation", "" },
  { "AllowAngleIterations", "" },
  { "AllowIsometricIterations", "" },
  { "AllowRigidIterations", "" },
  { "AllowRelaxationIterations", "" },
  { "AllowSewingIterations", "" },
  { "TestPanels", "" },
  { "UseNewton", "" },
  { "UseIsometricScheme", "" },
  { "UseRigidInterior", "" },
  { "ReleaseCurves", "remove % or give it a tolerance" },
  { "MakeAccessory", "change the type of % to accessory" },
  { "AllowLengthError", "" },
  { "CloseCuts", "" },
  { "NameGrain", "name a curve of the piece as grain: %" },
  { "GiveGrainAngle", "give degrees or \"free\" as grain" },
  { "TakeSofterCloth", "choose a cloth that gives more" },
  { "CheckUnit", "check the unit" },
  { "WidenNotches", "set notches farther apart in the pattern options" },
  { "PrintOnPages", "choose pages in the pattern options" },
  { "TakeLargerPaper", "choose a larger paper in the pattern options" },
  { "WriteOtherFormat", "export it as SVG or DXF" },
  { "NameAnotherFile", "choose another name or folder" },
};
}

//------------------------------------------------------------------------------
std::string remedyWords(const std::string& name)
{
  return wirewarp::phraseOf(phrases, name);
}

//------------------------------------------------------------------------------
std::string messageOf(const vtkFlatteningAlgorithm* filter)
{
  return wirewarp::describe(filter->GetStatusDefect(), wirewarp::remediesOf(filter), phrases);
}

//------------------------------------------------------------------------------
std::string messageOf(const vtkPatternWriter* writer)
{
  const std::string defect = writer->GetStatusDefect();
  // What the pipeline refuses has no parts.
  return defect.empty() ? writer->GetErrorMessage()
                        : wirewarp::describe(defect, wirewarp::remediesOf(writer), phrases);
}

//------------------------------------------------------------------------------
std::string savedWords(const std::string& path, vtkPatternWriter* writer)
{
  std::string words = "saved " + path;
  for (int k = 0; k < writer->GetNumberOfWarnings(); ++k)
  {
    words += "; " + std::string(writer->GetWarning(k));
  }
  // All patterns are smooth unless another tolerance is chosen.
  const bool usual = writer->GetFairTolerance() == vtkNew<vtkPatternWriter>()->GetFairTolerance();
  for (int k = 0; k < writer->GetNumberOfNotes(); ++k)
  {
    const int kind = writer->GetNoteKind(k);
    if (usual && (kind == vtkPatternWriter::SMOOTHED || kind == vtkPatternWriter::LEFT_ROUGH))
    {
      continue;
    }
    words += "; " + std::string(writer->GetNote(k));
  }
  return words;
}
}
