// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Paths/PathGraph.h"
#include "Surface/SurfaceTrace.h"

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

/// The points on the left of a path whose shortest way to it is as long as the distance, and leaves
/// it on that side: from where it leaves the path at right angles, or from corners in all
/// directions between. What is nearer to another part of the path, as inside of a corner, is left
/// out; all else stays, however often the path crosses itself. A path that ends on the boundary is
/// followed round its end until the boundary is met again.
///
/// Within a thousandth of the distance on the triangulated surface: for arcs tangents stand that
/// turn by 4 degrees at most, and meet up to six ten-thousandths of the arc's radius farther away.
/// \param distance positive to the left, negative to the right of who walks on the outside
///
/// Errors: EmptySurface; InvalidCurve (the path is not on the surface, or has no length; or a point
/// came out more than 5 % too far away in space); InvalidOption (the distance is zero or not
/// finite); CurveLeavesSurface (no point at this distance); NotConverged (the distance goes too
/// many ways round the surface); OutOfMemory.
PathOffset offsetPath(const PathGraph& graph, const SurfacePath& path, double distance);
}
