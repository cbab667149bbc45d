// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Axes across which the boundary of a disk, laid on a circle by lengths with its first vertex at
/// angle 0, may be its own mirror image: its turning along its length, smoothed, is the same the
/// other way round. As angles of the axes on that circle, in [0, pi), the likeliest first; an axis
/// between vertices that are images of each other is exact. Empty where the boundary has no such
/// axis.
std::vector<double> boundaryAxes(const TriangleMesh& mesh);
}
