// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"
#include "Paths/PathCourse.h"

namespace flattening
{
/// The least angle that a straightened path has on each side of a vertex that it goes through, less
/// pi.
inline constexpr double straightAngle = 5e-10;

/// Draws the course tight, its ends held: as long as it passes a vertex with an angle below pi on
/// one side, it is led round this side and the strip there shortened (N. Sharp and K. Crane, "You
/// can find geodesic paths in triangle meshes by just flipping edges", 2020, without the flips). It
/// only gets shorter. Sides where the surface ends are left.
/// \return the vertices where rounding left a smaller angle than straightAngle allows, and where
/// the turns were used up, ten for each vertex of the mesh and a thousand more; none as a rule.
Indices straighten(const TriangleMesh& mesh, PathCourse& course);
/// As above. \param mostTurns how often the course is led round a vertex
Indices straighten(const TriangleMesh& mesh, PathCourse& course, std::size_t mostTurns);
/// As the first, but only until it has unfolded so many half-edges, where it takes more.
/// \return whether it came to its end
bool straightenAWhile(
  const TriangleMesh& mesh, PathCourse& course, std::size_t mostUnfolded, Indices& bent);

/// A course along points of which each two neighbours lie in the triangle between them.
PathCourse courseAlong(const TriangleMesh& mesh, const SurfacePath& path);
/// The points at which a course passes knots and edges.
SurfacePath pathAlong(const TriangleMesh& mesh, const PathCourse& course);
}
