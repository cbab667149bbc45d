// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/SurfacePoint.h"
#include "Surface/SurfaceTrace.h"
#include "Surface/TriangleMesh.h"

#include <optional>
#include <vector>

namespace flattening
{
/// A straight piece of the offset in one triangle, the path on its right.
struct OffsetLine
{
  Index triangle = none;
  SurfacePoint from;
  SurfacePoint to;
};

/// The points at a distance from a path on its left, where no other way to the path is shorter.
/// Where the path ends or has a corner, and behind vertices with more than 2 pi around them, arcs
/// are tangents of 4 degrees. Method: OffsetFront in the source.
/// \param distance above 0
/// \return nothing where the front goes too many ways round the surface
std::optional<std::vector<OffsetLine>> offsetLines(
  const TriangleMesh& mesh, const SurfacePath& path, double distance);
}
