// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PathCourse.h"

namespace flattening
{
/// The shortest path between two points inside of the strip of triangles that a list of half-edges
/// crosses: the strip is unfolded into a plane and a string drawn tight in it (the funnel of D. T.
/// Lee and F. P. Preparata, 1984), in time linear in the number of half-edges.
///
/// Vertices that a leg passes closer than an angle of 1e-11 become knots as well.
/// \pre No half-edge holds an end at its end of the strip; the first is in a triangle of the start.
PathCourse shortestInStrip(const TriangleMesh& mesh, const SurfacePoint& start,
  const Indices& crossed, const SurfacePoint& end);

/// The list with steps back taken out, without the half-edges at its ends that hold the ends: the
/// strip that crosses the rest joins them in the same way.
Indices reducedStrip(const TriangleMesh& mesh, const SurfacePoint& start, const Indices& crossed,
  const SurfacePoint& end);

/// Where a leg leaves triangles: as fractions of its half-edges, the last vertex 1.
std::vector<double> crossingFractions(const TriangleMesh& mesh, const SurfacePoint& start,
  const Indices& crossed, const SurfacePoint& end);
}
