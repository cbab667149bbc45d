// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Imprint/SurfaceTrace.h"
#include "Paths/PathGraph.h"

namespace flattening
{
/// The curve at a distance from a path, measured over the surface.
struct PathOffset
{
  /// From end to end; one that ends where it starts is closed. More than one where the boundary or
  /// a hole interrupts it, or the path comes too near to itself.
  std::vector<SurfacePath> parts;
  Status status;
};

/// The points that straight lines reach which leave a path at right angles on its left, and at its
/// corners in all directions between, in arcs of 5 degrees at most; joined by straight paths. Where
/// those points are nearer to another part of the path, as inside of a corner, they are left out;
/// all others stay, however often the path crosses itself.
/// A path that ends on the boundary is followed round its end until the boundary is met again.
///
/// Exact where the surface can be unrolled, but for arcs, whose chords are up to a thousandth of
/// the distance inside. Elsewhere exact at its points, a quarter of an edge apart.
/// \param distance positive to the left, negative to the right of who walks on the outside
///
/// Errors: EmptySurface; InvalidCurve (the path is not on the surface, or has no length; or triangles
/// are so large beside the distance that the offset would be more than 5 % too far away in space);
/// InvalidOption (the distance is zero or not finite); CurveLeavesSurface (no point at this
/// distance); OutOfMemory.
PathOffset offsetPath(const PathGraph& graph, const SurfacePath& path, double distance);
}
