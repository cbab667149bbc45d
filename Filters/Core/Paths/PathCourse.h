// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfacePoint.h"

namespace flattening
{
/// One straight stretch of a path: over a strip of triangles that are unfolded into a plane, within
/// one triangle, or along an edge.
struct PathLeg
{
  /// The half-edges that it leaves triangles by, in order, none of which holds an end of the leg;
  /// empty within one triangle and along an edge.
  Indices crossed;
  double length = 0.0;
  /// At an end in a vertex, where half-edges are crossed: the angle from the half-edge on the right
  /// of who looks along the leg from there.
  double startAngle = 0.0;
  double endAngle = 0.0;
};

/// A path as an elastic string lies: legs between knots. Those between the two ends are vertices.
struct PathCourse
{
  std::vector<SurfacePoint> knots;
  std::vector<PathLeg> legs; ///< legs[i] joins knots[i] and knots[i + 1]
};
}
