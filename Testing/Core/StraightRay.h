// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PointDirections.h"

namespace flattening
{
/// Where a straight line over a surface ends.
struct StraightRay
{
  SurfacePoint end;
  /// It is as long as asked for; else it met the boundary, or starts out of the surface.
  bool arrived = false;
};

/// The straight line from a point in a direction: straight in triangles and across edges, with the
/// same angle on both sides of a vertex that it meets (K. Polthier and M. Schmies, "Straightest
/// geodesics on polyhedral surfaces", 1998). Along the boundary it goes on as long as the boundary
/// is straight or turns away from the surface.
/// \pre The point lies on the mesh, and the direction in a triangle that holds it.
StraightRay straightRay(const TriangleMesh& mesh, const SurfacePoint& start,
  const SurfaceDirection& direction, double length);
}
