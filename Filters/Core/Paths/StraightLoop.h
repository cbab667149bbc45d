// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/StraightPath.h"

namespace flattening
{
/// A closed path, its last point being its first, drawn tight in its class: as a rubber band that
/// cannot leave the surface comes to rest. Errors: InvalidCurve (the path is not closed, or not on
/// the surface); CurveTooShort (the band can be drawn together to a point); NotConverged (as for
/// straight paths); OutOfMemory.
StraightPath straightLoop(const PathGraph& graph, const SurfacePath& loop);

/// The same with some of its points held: straight between these. `held` are places in the list, in
/// ascending order, the first 0.
StraightPath straightLoopThrough(
  const PathGraph& graph, const SurfacePath& loop, const std::vector<std::size_t>& held);
}
