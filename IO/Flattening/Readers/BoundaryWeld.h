// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BoundaryLoops.h"

namespace wirewarp
{
struct WeldedPoints
{
  std::size_t count = 0;
  double farthest = 0.0; ///< distance that a point was moved
};

/// Joins points of the boundary with the nearest one of a lower id within a distance. The ends of
/// an edge become one only where they are coincident, so that no triangle is lost.
WeldedPoints weldBoundary(TriangleList& list, double coincident, double distance);

/// Edges of the boundary that run along another one between points of their own.
struct UnjoinedEdges
{
  std::size_t count = 0;
  std::int64_t point = 0; ///< the first of their points
  double gap = 0.0;       ///< largest distance of points that belong together
};

struct UnjoinedBoundary
{
  UnjoinedEdges coincident; ///< whose points lie within the distance `coincident` of each other
  UnjoinedEdges near;       ///< within `near`, and a tenth of the edges there
};
UnjoinedBoundary unjoinedEdges(
  const TriangleList& list, const std::vector<BoundaryLoop>& loops, double coincident, double near);
}
