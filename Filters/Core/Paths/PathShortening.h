// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A shorter path between the same ends, nearly straight at large: point after point of the path is
/// joined with the next but one by a plane section of the surface (G. D. Birkhoff's curve
/// shortening). Drawing it tight takes fewer steps, each of which moves a path by one vertex.
SurfacePath relaxed(const TriangleMesh& mesh, const SnapDistance& snap, SurfacePath path);

/// A path between the same ends that is no longer, moved towards where it would be straight were
/// the surface flat beside it: the triangles that it passes are unfolded into a plane (E. Cartan's
/// development), and points of it are moved sideways over the surface by their distance from the
/// chord, or by a multiple of it while that shortens the path; plane sections join them. One move
/// replaces many around single vertices, for a path that goes through few vertices.
SurfacePath developed(const TriangleMesh& mesh, const SnapDistance& snap, SurfacePath path);
}
