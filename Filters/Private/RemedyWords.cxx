// SPDX-License-Identifier: BSD-3-Clause
#include "RemedyWords.h"

namespace flattening
{
namespace bridge
{
const char* remedyWords(Remedy remedy)
{
  switch (remedy)
  {
    case Remedy::GiveTriangles:
      return "give a triangulated surface";
    case Remedy::WriteAgain:
      return "write the data again";
    case Remedy::MendPoints:
      return "mend or remove the points";
    case Remedy::RemeshTriangles:
      return "collapse the triangles or remesh there";
    case Remedy::RemoveDoubles:
      return "remove doubled triangles";
    case Remedy::SeparateSides:
      return "give the two sides of a thin surface points of their own";
    case Remedy::SeparateSheets:
      return "give the sheets as surfaces of their own";
    case Remedy::DoublePoint:
      return "double the point, slightly apart";
    case Remedy::JoinByEdge:
      return "join the parts by an edge";
    case Remedy::CutBandThrough:
      return "cut the mesh through across the band, each point of the cut twice (a seam comes too "
             "late for that)";
    case Remedy::CutOpen:
      return "cut it into pieces with seams or open it with a dart";
    case Remedy::OpenHandles:
      return "cut each handle open with a seam or dart";
    case Remedy::SkipClosed:
      return "leave out what cannot be laid flat (SkipClosed)";
    case Remedy::DivideInput:
      return "divide the data set";
    case Remedy::RedrawCurve:
      return "remove the curve or draw it again";
    case Remedy::ProjectPoints:
      return "project the points onto the surface";
    case Remedy::RaiseImprintTolerance:
      return "raise ImprintTolerance to %";
    case Remedy::AddCurvePoints:
      return "add points between them that follow the surface";
    case Remedy::EndAtBoundary:
      return "end the curve at the boundary";
    case Remedy::SplitTriangles:
      return "set SplitTriangles on";
    case Remedy::FollowEdges:
      return "draw the curve along edges";
    case Remedy::RaiseSnapTolerance:
      return "raise SnapTolerance";
    case Remedy::SpreadPlanarShape:
      return "move the points of its planar shape apart";
    case Remedy::NameCurve:
      return "name a curve that is there in SetCurveTolerance";
    case Remedy::TakeEdges:
      return "take the edges from the surface itself";
    case Remedy::Give:
      return "give %";
    case Remedy::NamePins:
      return "name two points of the surface in ConformalPins, or -1 for both";
    case Remedy::OrderRelaxation:
      return "give 0 <= RelaxationMinimumIterations <= RelaxationMaximumIterations, of them one at "
             "least, and a RelaxationMovement that is not negative";
    case Remedy::FreeMemory:
      return "close other programs, raise the limit of memory, or take a smaller surface";
    case Remedy::MendSlivers:
      return "mend slivers there";
    case Remedy::AllowAngleIterations:
      return "raise MaximumIterations";
    case Remedy::AllowIsometricIterations:
      return "raise IsometricMaximumIterations";
    case Remedy::AllowRigidIterations:
      return "raise RigidMaximumIterations";
    case Remedy::AllowRelaxationIterations:
      return "raise RelaxationMaximumIterations or RelaxationMovement, or set Interior to "
             "LAPLACIAN";
    case Remedy::AllowSewingIterations:
      return "raise MaximumIterations";
    case Remedy::TestPanels:
      return "set Test to PANEL";
    case Remedy::UseNewton:
      return "set Solver to NEWTON";
    case Remedy::UseIsometricScheme:
      return "set Scheme to ISOMETRIC";
    case Remedy::UseRigidInterior:
      return "set Interior to AS_RIGID_AS_POSSIBLE";
    case Remedy::SeamBetweenLoops:
      return "cut the piece open by a seam from one boundary loop to the next";
    case Remedy::ReleaseCurves:
      return "remove % or give a LengthTolerance";
    case Remedy::MakeAccessory:
      return "turn % into accessory curves (CurveType 0, or ReleaseKeys for all keys)";
    case Remedy::ChangeKeyShapes:
      return "change the shape of %";
    case Remedy::AllowLengthError:
      return "raise MaximumLengthError";
    case Remedy::AddDarts:
      return "add a dart there";
    case Remedy::CloseCuts:
      return "close the cuts as far as they cross (CloseCuts)";
    case Remedy::DivideBySeam:
      return "divide the piece there by a seam";
    case Remedy::NameGrain:
      return "name a curve of the piece as Grain: %";
    case Remedy::GiveGrainAngle:
      return "give degrees or \"free\" as Grain";
    case Remedy::TakeSofterCloth:
      return "take a Material that gives more";
    case Remedy::ReadTheFlattening:
      return "see what the flattening says";
    case Remedy::GiveFlatPieces:
      return "give the outputs of one flattening filter";
    case Remedy::CheckUnit:
      return "check the unit (Unit)";
    case Remedy::WidenNotches:
      return "raise NotchSpacing";
    case Remedy::PrintOnPages:
      return "set Paper to A4, LETTER, A3 or A0, for several pages";
    case Remedy::TakeLargerPaper:
      return "set Paper to larger paper";
    case Remedy::WriteOtherFormat:
      return "write SVG or DXF";
    case Remedy::NameAnotherFile:
      return "name another file or folder";
  }
  return "";
}

std::string inWords(const Status& status)
{
  std::string text = status.message;
  const char* join = "; ";
  for (const SuggestedRemedy& suggested : status.remedies)
  {
    std::string words = remedyWords(suggested.remedy);
    const std::size_t at = words.find('%');
    text += join + (at == std::string::npos ? words : words.replace(at, 1, suggested.subject));
    join = ", or ";
  }
  return text;
}
}
}
