// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Status.h"

#include <cstdio>

#include <algorithm>
#include <array>

namespace flattening
{
namespace
{
struct StatusRow
{
  StatusCode code;
  const char* name;
  int severity;
};

/// Of errors.
constexpr int worst = 8;

constexpr std::array<StatusRow, statusCount> statuses{ {
  { StatusCode::Ok, "Ok", 0 },
  { StatusCode::Cancelled, "Cancelled", worst },
  { StatusCode::EmptySurface, "EmptySurface", worst },
  { StatusCode::NonFinitePoint, "NonFinitePoint", worst },
  { StatusCode::InvalidPointId, "InvalidPointId", worst },
  { StatusCode::DegenerateTriangle, "DegenerateTriangle", worst },
  { StatusCode::NonManifoldEdge, "NonManifoldEdge", worst },
  { StatusCode::NonManifoldVertex, "NonManifoldVertex", worst },
  { StatusCode::NotOrientable, "NotOrientable", worst },
  { StatusCode::ClosedSurface, "ClosedSurface", worst },
  { StatusCode::Handle, "Handle", worst },
  { StatusCode::CurveTooShort, "CurveTooShort", worst },
  { StatusCode::CurvePointOffSurface, "CurvePointOffSurface", worst },
  { StatusCode::CurveLeavesSurface, "CurveLeavesSurface", worst },
  { StatusCode::CurveNotOnEdges, "CurveNotOnEdges", worst },
  { StatusCode::InvalidCurve, "InvalidCurve", worst },
  { StatusCode::InvalidOption, "InvalidOption", worst },
  { StatusCode::OutOfMemory, "OutOfMemory", worst },
  { StatusCode::NumericalFailure, "NumericalFailure", worst },
  { StatusCode::NotConverged, "NotConverged", 5 },
  { StatusCode::IncompatibleKeys, "IncompatibleKeys", 6 },
  { StatusCode::LengthError, "LengthError", 7 },
  { StatusCode::FlippedTriangles, "FlippedTriangles", 4 },
  { StatusCode::Overlap, "Overlap", 3 },
  { StatusCode::MissingGrain, "MissingGrain", 2 },
  { StatusCode::BeyondLimits, "BeyondLimits", 1 },
  { StatusCode::NothingToDraw, "NothingToDraw", worst },
  { StatusCode::InvalidPattern, "InvalidPattern", worst },
  { StatusCode::PatternTooLarge, "PatternTooLarge", worst },
  { StatusCode::FileNotWritten, "FileNotWritten", worst },
} };

struct RemedyRow
{
  Remedy code;
  const char* name;
  const char* sentence;
};

constexpr std::array<RemedyRow, remedyCount> remedies{ {
  { Remedy::GiveTriangles, "GiveTriangles", "give a triangulated surface" },
  { Remedy::WriteAgain, "WriteAgain", "write the data again, with ids that exist" },
  { Remedy::MendPoints, "MendPoints", "mend or remove the points" },
  { Remedy::RemeshTriangles, "RemeshTriangles", "collapse the triangles or remesh there" },
  { Remedy::RemoveDoubles, "RemoveDoubles", "remove doubled triangles" },
  { Remedy::SeparateSides, "SeparateSides",
    "give the two sides of a thin surface points of their own" },
  { Remedy::SeparateSheets, "SeparateSheets", "give the sheets as surfaces of their own" },
  { Remedy::DoublePoint, "DoublePoint", "double the point, slightly apart" },
  { Remedy::JoinByEdge, "JoinByEdge", "join the parts by an edge" },
  { Remedy::CutBandThrough, "CutBandThrough",
    "cut the mesh through across the band, each point of the cut twice (a seam comes too late for "
    "that)" },
  { Remedy::CutOpen, "CutOpen",
    "cut it into pieces with seams or open it with a dart[, such as {vtkFeatureCurveSuggestion} "
    "proposes]" },
  { Remedy::OpenHandles, "OpenHandles", "cut each handle open with a seam or dart" },
  { Remedy::SkipClosed, "SkipClosed", "leave out what cannot be laid flat ({SkipClosed=on})" },
  { Remedy::DivideInput, "DivideInput", "divide the data set" },
  { Remedy::RedrawCurve, "RedrawCurve", "remove the curve or draw it again" },
  { Remedy::ProjectPoints, "ProjectPoints", "project the points onto the surface" },
  { Remedy::RaiseImprintTolerance, "RaiseImprintTolerance", "raise {ImprintTolerance} to %" },
  { Remedy::AddCurvePoints, "AddCurvePoints", "add points between them that follow the surface" },
  { Remedy::EndAtBoundary, "EndAtBoundary", "end the curve at the boundary" },
  { Remedy::SplitTriangles, "SplitTriangles", "let triangles be split ({SplitTriangles=on})" },
  { Remedy::FollowEdges, "FollowEdges", "draw the curve along edges" },
  { Remedy::RaiseSnapTolerance, "RaiseSnapTolerance", "raise {SnapTolerance}" },
  { Remedy::SpreadPlanarShape, "SpreadPlanarShape", "move the points of its planar shape apart" },
  { Remedy::NameCurve, "NameCurve", "name one of the curves for {CurveTolerances}" },
  { Remedy::TakeEdges, "TakeEdges", "take the edges from the surface itself" },
  { Remedy::Give, "Give", "give %" },
  { Remedy::NamePins, "NamePins", "name two points of the surface in {Pins}, or none" },
  { Remedy::OrderRelaxation, "OrderRelaxation",
    "give 0 <= {RelaxationMinimumIterations} <= {RelaxationMaximumIterations}, at least 1, and "
    "{RelaxationMovement} from 0" },
  { Remedy::FreeMemory, "FreeMemory",
    "close other programs, raise the limit of memory, or take a smaller surface" },
  { Remedy::MendSlivers, "MendSlivers", "mend slivers there" },
  { Remedy::AllowAngleIterations, "AllowAngleIterations", "raise {MaximumIterations}" },
  { Remedy::AllowIsometricIterations, "AllowIsometricIterations",
    "raise {IsometricMaximumIterations}" },
  { Remedy::AllowRigidIterations, "AllowRigidIterations", "raise {RigidMaximumIterations}" },
  { Remedy::AllowRelaxationIterations, "AllowRelaxationIterations",
    "raise {RelaxationMaximumIterations} or {RelaxationMovement}, or use {Interior=LAPLACIAN}, "
    "which solves the same equation at once" },
  { Remedy::AllowSewingIterations, "AllowSewingIterations", "raise {Sewing.MaximumIterations}" },
  { Remedy::TestPanels, "TestPanels", "use {Sewing.Test=PANEL}" },
  { Remedy::UseNewton, "UseNewton", "use {Solver=NEWTON}" },
  { Remedy::UseIsometricScheme, "UseIsometricScheme", "use {Scheme=ISOMETRIC}" },
  { Remedy::UseRigidInterior, "UseRigidInterior", "use {Interior=AS_RIGID_AS_POSSIBLE}" },
  { Remedy::SeamBetweenLoops, "SeamBetweenLoops",
    "cut the piece open by a seam from one boundary loop to the next" },
  { Remedy::ReleaseCurves, "ReleaseCurves", "remove % or make it elastic ({LengthTolerance})" },
  { Remedy::MakeAccessory, "MakeAccessory",
    "turn % into accessory curves ({CurveType=0}[, or {ReleaseKeys=on} for all keys])" },
  { Remedy::ChangeKeyShapes, "ChangeKeyShapes", "change the shape of %" },
  { Remedy::AllowLengthError, "AllowLengthError", "raise {MaximumLengthError}" },
  { Remedy::AddDarts, "AddDarts", "add a dart there" },
  { Remedy::PreventOverlap, "PreventOverlap",
    "keep the boundary from crossing itself ({PreventOverlap=on})" },
  { Remedy::CloseCuts, "CloseCuts", "close the cuts where they cross ({CloseCuts=on})" },
  { Remedy::DivideBySeam, "DivideBySeam", "divide the piece there by a seam" },
  { Remedy::NameGrain, "NameGrain", "name a curve of the piece with {Grain}: %" },
  { Remedy::GiveGrainAngle, "GiveGrainAngle", "give degrees or \"free\" as {Grain}" },
  { Remedy::TakeSofterCloth, "TakeSofterCloth",
    "take a material that may be strained more[ ({Material})]" },
  { Remedy::ReadTheFlattening, "ReadTheFlattening", "read the status of the flattening" },
  { Remedy::GiveFlatPieces, "GiveFlatPieces", "give the outputs of one flattening filter" },
  { Remedy::CheckUnit, "CheckUnit", "check the unit[ ({Unit})]" },
  { Remedy::WidenNotches, "WidenNotches", "raise {NotchSpacing}" },
  { Remedy::PrintOnPages, "PrintOnPages",
    "print on several pages ({Paper}: A4, letter, A3 or A0)" },
  { Remedy::TakeLargerPaper, "TakeLargerPaper", "take larger paper[ ({Paper})]" },
  { Remedy::WriteOtherFormat, "WriteOtherFormat", "write SVG or DXF" },
  { Remedy::NameAnotherFile, "NameAnotherFile", "name another file or folder" },
} };

template <class Rows>
constexpr bool isInOrder(const Rows& rows)
{
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    if (static_cast<std::size_t>(rows[k].code) != k)
    {
      return false;
    }
  }
  return true;
}
static_assert(isInOrder(statuses) && isInOrder(remedies));

template <class Elements, class Text>
std::string listed(const Elements& elements, std::size_t most, const Text& textOf)
{
  std::string text;
  for (std::size_t i = 0; i < std::min(elements.size(), most); ++i)
  {
    text += (i ? ", " : "") + textOf(elements[i]);
  }
  if (elements.size() > most)
  {
    text += " and " + std::to_string(elements.size() - most) + " more";
  }
  return text;
}
}

int severity(StatusCode code)
{
  return statuses[static_cast<std::size_t>(code)].severity;
}

const char* statusName(StatusCode code)
{
  return statuses[static_cast<std::size_t>(code)].name;
}

const char* remedyName(Remedy remedy)
{
  return remedies[static_cast<std::size_t>(remedy)].name;
}

const char* remedySentence(Remedy remedy)
{
  return remedies[static_cast<std::size_t>(remedy)].sentence;
}

Status invalidOption(std::string defect, std::string give)
{
  return { StatusCode::InvalidOption, std::move(defect), {},
    { { Remedy::Give, std::move(give) } } };
}

std::string listIds(const Indices& ids, std::size_t most)
{
  return listed(ids, most, [](std::int64_t id) { return std::to_string(id); });
}

std::string listIds(const std::vector<std::int64_t>& ids, std::size_t most)
{
  return listed(ids, most, [](std::int64_t id) { return std::to_string(id); });
}

std::string listNames(const std::vector<std::string>& names, std::size_t most)
{
  return listed(names, most, [](const std::string& name) { return name; });
}

std::string shortNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string percent(double fraction)
{
  return shortNumber(100.0 * fraction) + " %";
}
}
