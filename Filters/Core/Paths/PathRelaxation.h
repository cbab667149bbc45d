// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"

namespace flattening
{
/// A shorter path between the same ends, nearly straight at large: point after point of the path is
/// joined with the next but one by a plane section of the surface (G. D. Birkhoff's curve
/// shortening). Drawing it tight takes fewer steps, each of which moves a path by one vertex.
SurfacePath relaxed(const TriangleMesh& mesh, const SnapDistance& snap, SurfacePath path);
}
