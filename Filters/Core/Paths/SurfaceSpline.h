// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/StraightPath.h"

namespace flattening
{
struct SurfaceSpline
{
  SurfacePath path;
  double length = 0.0;
  /// Where the points that it was drawn through are in the list of the path.
  std::vector<std::size_t> stations;
  Status status;
};

/// A smooth curve over a surface through points of it, in this order: the interpolatory subdivision
/// scheme of four points over the square roots of their distances (N. Dyn, M. S. Floater and K.
/// Hormann, 2009), with points along straight paths in the place of sums. Between the points of the
/// last round it is straight. A closed one ends in its first point.
///
/// Errors: as of straight paths; CurveTooShort (fewer than two points, three where it is closed).
SurfaceSpline surfaceSpline(const PathGraph& graph, const SurfaceLocator& locator,
  const std::vector<SurfacePoint>& points, bool closed, int rounds = 5);
}
