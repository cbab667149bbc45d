// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// Whether a point is a vertex, edge or triangle of the mesh.
bool liesOn(const TriangleMesh& mesh, const SurfacePoint& point);
/// Whether each two neighbours lie in the triangle between them, and all ids are of the mesh.
bool liesOn(const TriangleMesh& mesh, const SurfacePath& path);

/// Errors: EmptySurface; InvalidPointId (a point of no such vertex, edge or triangle). \param what
/// ends or starts there, in the message.
Status checkPoints(
  const TriangleMesh& mesh, const std::vector<SurfacePoint>& points, const std::string& what);

/// Weights of a triangle's corners at a point of it.
std::array<double, 3> weightsIn(
  const TriangleMesh& mesh, Index triangle, const SurfacePoint& point);

/// A point of a triangle by the weights of its corners; on an edge or at a vertex where weights
/// are zero.
SurfacePoint pointOf(
  const TriangleMesh& mesh, Index triangle, const std::array<double, 3>& weights);
/// The point at fraction s of the segment between two points of a triangle; on the triangle's edge
/// where both are.
SurfacePoint pointBetween(
  const TriangleMesh& mesh, Index triangle, const SurfacePoint& a, const SurfacePoint& b, double s);
/// The point of a path at a length from its start.
SurfacePoint pointAlong(const TriangleMesh& mesh, const SurfacePath& path, double distance);

/// From one point of a path to another, by their places in the list.
SurfacePath partOf(const SurfacePath& path, std::size_t first, std::size_t last);
SurfacePath reversed(SurfacePath path);
/// Adds a path that starts where this one ends.
void append(SurfacePath& path, const SurfacePath& more);
}
