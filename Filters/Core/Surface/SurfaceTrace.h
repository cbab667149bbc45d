// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/SurfacePoint.h"

#include <limits>

namespace flattening
{
/// A path over the surface, straight in each triangle.
struct SurfacePath
{
  std::vector<SurfacePoint> points;
  /// triangles[i] holds points[i] and points[i + 1].
  Indices triangles;
  bool arrived = false;
  /// It did not arrive, because it met the boundary at points.back().
  bool atBoundary = false;
};

double lengthOf(const SurfacePath& path);

/// Lays a straight segment onto the surface: the section of the surface with the plane through both
/// ends and the surface's normal there (the mean of both; where that fails, that at one end, or
/// sideways). In one triangle it is the straight segment itself.
///
/// A section that passes a vertex within the snap distance goes through the vertex. One that gets
/// longer than `longest` does not arrive.
SurfacePath traceSegment(const TriangleMesh& mesh, const SnapDistance& snap,
  const SurfacePoint& start, const SurfacePoint& end,
  double longest = std::numeric_limits<double>::infinity());
}
