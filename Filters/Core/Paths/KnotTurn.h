// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PathCourse.h"

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
VertexDirection leavingDirection(
  const TriangleMesh& mesh, const SurfacePoint& vertex, const PathLeg& leg, const SurfacePoint& to);
VertexDirection arrivingDirection(const TriangleMesh& mesh, const SurfacePoint& from,
  const PathLeg& leg, const SurfacePoint& vertex);

/// The sector from one direction anti-clockwise to the other; `crossed` in this order.
KnotSide sectorBetween(
  const TriangleMesh& mesh, const VertexDirection& from, const VertexDirection& to);

/// The side of a knot with the smaller angle, `crossed` along the path.
/// \pre The knot between the legs is a vertex.
KnotSide sharperSide(const TriangleMesh& mesh, const SurfacePoint& before, const PathLeg& arriving,
  const SurfacePoint& knot, const PathLeg& leaving, const SurfacePoint& after);
}
