// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Paths/PathGraph.h"
#include "Surface/SurfaceLocator.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A path drawn anew through few of its points.
struct FittedPath
{
  /// Points of the path; of a closed one the first is not repeated.
  std::vector<SurfacePoint> nodes;
  /// Between the nodes; of a closed one back to the first as well.
  std::vector<SurfacePath> segments;
  Status status;
};

/// Straight paths from point to point of a path, no farther from it than the tolerance; ends are
/// kept. A path that ends where it starts is closed.
///
/// Errors of both: InvalidCurve (not on the surface, or without length); InvalidOption (the
/// tolerance is not positive); those of straightPath(); NotConverged (a spline that is not near
/// enough); OutOfMemory.
FittedPath fitStraightPaths(const PathGraph& graph, const SurfacePath& path, double tolerance);

/// A spline through points of a path, no farther from it than the tolerance, as surfaceSpline()
/// draws it; what a stroke by hand becomes.
FittedPath fitSpline(
  const PathGraph& graph, const SurfaceLocator& locator, const SurfacePath& path, double tolerance);
}
