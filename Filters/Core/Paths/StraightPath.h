// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Base/Status.h"
#include "Paths/PathSearch.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A path that is as straight as the surface lets it be: straight in each triangle and across each
/// edge, with at least pi on both sides of each vertex that it goes through, unless the surface
/// ends there. No path near it is shorter.
struct StraightPath
{
  SurfacePath path;
  double length = 0.0;
  Status status;
};

/// The straight path between two points anywhere on a surface.
///
/// It starts from the shortest way of the graph and is drawn tight, so that it is never longer than
/// any way by edges. Where bumps or handles leave several straight paths, it is the one that lies
/// as that way does.
///
/// Errors: EmptySurface; InvalidPointId (a point of no such vertex, edge or triangle);
/// CurveLeavesSurface (the points lie on different components); NotConverged (there is a path, but
/// rounding left a sharper angle at vertices; ids: points); OutOfMemory.
StraightPath straightPath(const PathGraph& graph, const SurfacePoint& from, const SurfacePoint& to);
/// As above, from the source of a search, whichever targets it has had before. \pre The source lies
/// on the surface, and the search takes all ways.
StraightPath straightPath(PathSearch& search, const SurfacePoint& to);

/// The straight path that lies near the plane section between two points that are close to each
/// other; without a search, in a time that does not depend on the size of the surface.
StraightPath localStraightPath(
  const PathGraph& graph, const SurfacePoint& from, const SurfacePoint& to);

/// The straight path that lies near an earlier one, the hint: whoever drags an end gets a path that
/// moves along and never jumps to the other side of a bump. The hint's ends need not be the new
/// ones; any polyline of the surface will do. Errors: as above, and InvalidCurve (the hint is no
/// path of this surface).
StraightPath straightPathNear(const PathGraph& graph, const SurfacePath& hint,
  const SurfacePoint& from, const SurfacePoint& to);

/// The shortest way by edges, and in the triangles of both ends; not drawn tight. Errors: as above.
StraightPath pathByEdges(const PathGraph& graph, const SurfacePoint& from, const SurfacePoint& to);
/// As above, from the source of a search by edges.
StraightPath pathByEdges(PathSearch& search, const SurfacePoint& to);

/// A closed path, its last point being its first, drawn tight in its class: as a rubber band that
/// cannot leave the surface comes to rest. Errors: InvalidCurve (the path is not closed, or not on
/// the surface); CurveTooShort (the band can be drawn together to a point); NotConverged (as for
/// straight paths); OutOfMemory.
StraightPath straightLoop(const PathGraph& graph, const SurfacePath& loop);
}
