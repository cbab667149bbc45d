// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Remedy.h"
#include "Base/Types.h"

#include <string>
#include <utility>

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

/// What a stage has to say of its result. Codes up to LastRefusal, and those of patterns, mean that
/// there is no result; the others that there is one, but that a promise is broken.
enum class StatusCode
{
  Ok,
  // No result: the input is refused or the run was cancelled.
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
  // A result, with a broken promise.
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

/// How bad a code is, for the one place that decides which of several is told: refusals above
/// broken promises, and of these lengths that are off above shapes of keys that are given up, what
/// is not at a minimum, flips, overlaps, and what a cloth has to bear: a grain
/// without its curve, strains beyond limits. 0 where all is well.
int severity(StatusCode code);

/// Short fixed name of a code ("NonManifoldEdge"), for reports and tests.
const char* statusName(StatusCode code);

/// Outcome of a stage: the defect, the first offending elements, and the ways out.
struct Status
{
  StatusCode code = StatusCode::Ok;
  std::string message; ///< the defect alone; the user interface adds the ways out in its words
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

/// The first few ids as text, "3, 7, 12 and 5 more".
std::string listIds(const Indices& ids, std::size_t most = 5);
std::string listIds(const std::vector<std::int64_t>& ids, std::size_t most = 5);
/// A number for a message, with four digits.
std::string shortNumber(double value);
/// Such as "2.5 %" of 0.025.
std::string percent(double fraction);
}
