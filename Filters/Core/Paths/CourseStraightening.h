// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/StripUnfolding.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A direction at a vertex.
struct VertexDirection
{
  Index halfedge = none;  ///< leaves the vertex; its triangle holds the direction
  double angle = 0.0;     ///< from the half-edge, anti-clockwise
  bool alongEdge = false; ///< along the half-edge itself
};

/// How a path goes round a vertex on one of its sides.
struct KnotSide
{
  double angle = 0.0; ///< infinite where the surface ends
  /// The half-edges that a path crosses which leaves the vertex on its other side.
  Indices crossed;
  bool left = false; ///< of the path
};

/// Whether the ends of a leg are such that it runs along an edge or within one triangle: then the
/// direction of the leg from a knot that is a vertex, towards the other end.
VertexDirection directionWithin(
  const TriangleMesh& mesh, const SurfacePoint& vertex, const SurfacePoint& other);
/// Direction of a leg that leaves a vertex, and of one that arrives there, seen from the vertex.
VertexDirection leavingDirection(const TriangleMesh& mesh, const SurfacePoint& vertex,
  const GeodesicSegment& leg, const SurfacePoint& to);
VertexDirection arrivingDirection(const TriangleMesh& mesh, const SurfacePoint& from,
  const GeodesicSegment& leg, const SurfacePoint& vertex);

/// The sector from one direction anti-clockwise to the other; `crossed` in this order.
KnotSide sectorBetween(
  const TriangleMesh& mesh, const VertexDirection& from, const VertexDirection& to);

/// The side of a knot with the smaller angle, `crossed` along the path.
/// \pre The knot between the legs is a vertex.
KnotSide sharperSide(const TriangleMesh& mesh, const SurfacePoint& before,
  const GeodesicSegment& arriving, const SurfacePoint& knot, const GeodesicSegment& leaving,
  const SurfacePoint& after);

/// The least angle that a straightened path has on each side of a vertex that it goes through, less
/// pi.
inline constexpr double straightAngle = 5e-10;

/// Draws the course tight, its ends held: as long as it passes a vertex with an angle below pi on
/// one side, it is led round this side and the strip there shortened (N. Sharp and K. Crane, "You
/// can find geodesic paths in triangle meshes by just flipping edges", 2020, without the flips). It
/// only gets shorter. Sides where the surface ends are left.
/// \return the vertices where rounding left a smaller angle than straightAngle allows, and where
/// the turns were used up, ten for each vertex of the mesh and a thousand more; none as a rule.
Indices straighten(const TriangleMesh& mesh, GeodesicPath& course);
/// As above. \param mostTurns how often the course is led round a vertex
Indices straighten(const TriangleMesh& mesh, GeodesicPath& course, std::size_t mostTurns);
/// As the first, but only until it has unfolded so many half-edges, where it takes more.
/// \return whether it came to its end
bool straightenWithBudget(
  const TriangleMesh& mesh, GeodesicPath& course, std::size_t mostUnfolded, Indices& bent);

/// A course along points of which each two neighbours lie in the triangle between them.
GeodesicPath courseAlong(const TriangleMesh& mesh, const SurfacePath& path);
/// The points at which a course passes knots and edges.
SurfacePath pathAlong(const TriangleMesh& mesh, const GeodesicPath& course);
}
