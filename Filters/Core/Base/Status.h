// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <string>
#include <utility>
#include <vector>

namespace flattening
{
/// What ids are ids of.
enum class ElementKind
{
  None,
  Points, ///< of the surface
  Cells,  ///< triangles
  Curves,
  CurvePoints, ///< in the caller's data of the curve
  Edges,       ///< pairs of points of the surface
  WirePatches, ///< of a piece
  WireNodes,   ///< of a piece
};

/// Ids that know what they are ids of; wide enough for those of any caller.
struct ElementIds
{
  ElementKind kind = ElementKind::None;
  std::vector<std::int64_t> values;

  ElementIds() = default;
  ElementIds(ElementKind what, const Indices& ids)
    : ElementIds(what, std::vector<std::int64_t>(ids.begin(), ids.end()))
  {
  }
  ElementIds(ElementKind what, std::vector<std::int64_t> ids)
    : kind(ids.empty() ? ElementKind::None : what)
    , values(std::move(ids))
  {
  }

  bool empty() const { return this->values.empty(); }
  bool operator==(const ElementIds& other) const
  {
    return this->kind == other.kind && this->values == other.values;
  }
};

/// Codes up to LastRefusal, and those of patterns, are errors: there is no result. The others are
/// warnings about a result.
enum class StatusCode
{
  Ok,
  // Errors: the input is rejected or the run was cancelled.
  Cancelled,
  EmptySurface,
  NonFinitePoint,
  InvalidPointId,
  DegenerateTriangle,
  NonManifoldEdge,
  NonManifoldVertex,
  NotOrientable,
  ClosedSurface,
  Handle,
  CurveTooShort,
  CurvePointOffSurface,
  CurveLeavesSurface,
  CurveNotOnEdges,
  InvalidCurve,
  InvalidOption,
  OutOfMemory,
  NumericalFailure,
  LastRefusal = NumericalFailure,
  // Warnings.
  NotConverged,
  IncompatibleKeys,
  LengthError,
  FlippedTriangles,
  Overlap,
  MissingGrain,
  BeyondLimits,
  // No pattern.
  NothingToDraw,   ///< no piece, or a piece without area
  InvalidPattern,  ///< broken ids, infinite coordinates, an outline that is no loop
  PatternTooLarge, ///< for the pages
  FileNotWritten,
};

inline constexpr int statusCount = static_cast<int>(StatusCode::FileNotWritten) + 1;

/// Which of several statuses counts: errors above warnings, and of these wrong lengths above shapes
/// of keys that are given up, what is not at a minimum, flips, overlaps, a grain without its curve,
/// strains beyond limits. 0 where all is well.
int severity(StatusCode code);

/// Short fixed name of a code ("NonManifoldEdge"), for reports and tests.
const char* statusName(StatusCode code);

/// Remedies of a defect. Each user interface spells the options in them by its own names.
enum class Remedy
{
  // The surface.
  GiveTriangles,
  WriteAgain,
  MendPoints,
  RemeshTriangles,
  RemoveDoubles,
  SeparateSides,
  SeparateSheets,
  DoublePoint,
  JoinByEdge,
  CutBandThrough,
  CutOpen,
  OpenHandles,
  SkipClosed,
  DivideInput,
  // Curves.
  RedrawCurve,
  ProjectPoints,
  RaiseImprintTolerance,
  AddCurvePoints,
  EndAtBoundary,
  SplitTriangles,
  FollowEdges,
  RaiseSnapTolerance,
  SpreadPlanarShape,
  NameCurve,
  TakeEdges,
  // Options.
  Give, ///< subject: what to give
  NamePins,
  OrderRelaxation,
  // The machine.
  FreeMemory,
  // The solution.
  MendSlivers,
  AllowAngleIterations,
  AllowIsometricIterations,
  AllowRigidIterations,
  AllowRelaxationIterations,
  AllowSewingIterations,
  TestPanels,
  UseNewton,
  UseIsometricScheme,
  UseRigidInterior,
  SeamBetweenLoops,
  ReleaseCurves,   ///< subject: which, accessory and key curves
  MakeAccessory,   ///< subject: key curves
  ChangeKeyShapes, ///< subject: key curves
  AllowLengthError,
  AddDarts,
  PreventOverlap,
  CloseCuts,
  DivideBySeam,
  NameGrain, ///< subject: curves of the piece
  GiveGrainAngle,
  TakeSofterCloth,
  // The pattern.
  ReadTheFlattening,
  GiveFlatPieces,
  CheckUnit,
  WidenNotches,
  PrintOnPages,
  TakeLargerPaper,
  WriteOtherFormat,
  NameAnotherFile,
};

inline constexpr int remedyCount = static_cast<int>(Remedy::NameAnotherFile) + 1;

/// Short fixed name of a remedy ("CloseCuts"), for reports and programs.
const char* remedyName(Remedy remedy);

/// What to do, as one sentence. % stands for the subject, {Property} and {Property=VALUE} for an
/// option of the filters, {Sewing.Property} for one of the sewing filter, or for another filter. A
/// user interface puts its own spelling there. One that lacks the option leaves out the remedy, or
/// only the part within [].
const char* remedySentence(Remedy remedy);

/// A remedy and what it is to be applied to.
struct SuggestedRemedy
{
  // NOLINTNEXTLINE(google-explicit-constructor): a list of remedies is a list of suggestions
  SuggestedRemedy(Remedy which, std::string what = {})
    : remedy(which)
    , subject(std::move(what))
  {
  }

  Remedy remedy;
  std::string subject; ///< names or numbers, where the remedy has one
};

using SuggestedRemedies = std::vector<SuggestedRemedy>;

/// Outcome of a stage: the defect, the first offending elements, and the remedies.
struct Status
{
  StatusCode code = StatusCode::Ok;
  std::string message; ///< the defect alone; the user interface adds the remedies
  ElementIds ids = {};
  SuggestedRemedies remedies = {};
  Index curve = none; ///< the polyline that is to blame, where it is one

  bool ok() const { return this->code == StatusCode::Ok; }
  /// True where there is no result at all.
  bool refused() const
  {
    return this->code != StatusCode::Ok &&
      (this->code <= StatusCode::LastRefusal || this->code >= StatusCode::NothingToDraw);
  }
};

/// InvalidOption with what to give instead.
Status invalidOption(std::string defect, std::string give);

/// The first few ids as text, "3, 7, 12 and 5 more".
std::string listIds(const Indices& ids, std::size_t most = 5);
std::string listIds(const std::vector<std::int64_t>& ids, std::size_t most = 5);
std::string listNames(const std::vector<std::string>& names, std::size_t most);
/// A number for a message, with four digits.
std::string shortNumber(double value);
/// Such as "2.5 %" of 0.025.
std::string percent(double fraction);
}
