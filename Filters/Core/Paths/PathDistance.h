// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/StraightPath.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A place of a path.
struct PathFoot
{
  std::size_t segment = 0;
  double along = 0.0; ///< fraction of the segment
  double gap = 0.0;   ///< in space, to a point
};
/// On one segment, the place that is nearest in space.
PathFoot footOnSegment(const SurfacePath& path, std::size_t segment, const Point3& point);
/// How far a point is from a path in space. No way over the surface is shorter.
double gapInSpace(const SurfacePath& path, const Point3& point);

/// The shortest straight path from a path to a point, and on which side it leaves.
struct PathDistance
{
  StraightPath way; ///< from the path to the point
  bool left = false;
};

/// Where several parts of the path are near, each is looked at. Errors: as of straightPath().
PathDistance distanceFrom(
  const PathGraph& graph, const SurfacePath& path, const SurfacePoint& point);
}
