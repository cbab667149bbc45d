// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"

namespace flattening
{
/// A path between the same ends that is no longer, moved towards where it would be straight were
/// the surface flat beside it: the triangles that it passes are unfolded into a plane (E. Cartan's
/// development), and points of it go to the side, straight over the surface, as far as they lie
/// from the chord there, or a multiple of that as long as it helps; plane sections join them. One
/// move in the place of many round a vertex each, for a path that goes through few vertices.
SurfacePath developed(const TriangleMesh& mesh, const SnapDistance& snap, SurfacePath path);
}
