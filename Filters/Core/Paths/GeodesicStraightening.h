// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/StripUnfolding.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// How a path goes round a vertex on one of its sides.
struct VertexSide
{
  double angle = 0.0; ///< infinite where the surface ends
  /// The half-edges that a path crosses which leaves the vertex on its other side.
  Indices crossed;
  bool left = false; ///< of the path
};

/// The side of a vertex with the smaller angle, `crossed` along the path.
/// \pre The point between the segments is a vertex.
VertexSide sharperSide(const TriangleMesh& mesh, const SurfacePoint& before,
  const GeodesicSegment& arriving, const SurfacePoint& vertex, const GeodesicSegment& leaving,
  const SurfacePoint& after);

/// The least angle that a straightened path has on each side of a vertex that it goes through, less
/// pi.
inline constexpr double straightAngle = 5e-10;

/// Draws the path tight, its ends held: as long as it passes a vertex with an angle below pi on
/// one side, it is led round this side and the strip there shortened (N. Sharp and K. Crane, "You
/// can find geodesic paths in triangle meshes by just flipping edges", 2020, without the flips). It
/// only gets shorter. Sides where the surface ends are left.
/// \return the vertices where rounding left a smaller angle than straightAngle allows, and where
/// the turns were used up, ten for each vertex of the mesh and a thousand more; none as a rule.
Indices straighten(const TriangleMesh& mesh, GeodesicPath& geodesic);

/// A path along points of which each two neighbours lie in the triangle between them.
GeodesicPath geodesicAlong(const TriangleMesh& mesh, const SurfacePath& path);
/// The points at which a path passes vertices and edges.
SurfacePath pathAlong(const TriangleMesh& mesh, const GeodesicPath& geodesic);
}
