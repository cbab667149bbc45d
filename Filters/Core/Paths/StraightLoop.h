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
}
