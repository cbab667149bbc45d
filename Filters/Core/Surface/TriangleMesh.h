// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Base/Types.h"

#include <memory>
#include <utility>

namespace flattening
{
/// A manifold, oriented triangle mesh as compact half-edges over flat arrays.
///
/// Half-edge h = 3 t + k runs in triangle t from its corner k to corner (k + 1) mod 3, the triangle
/// on its left. Half-edges keep their ids when a mesh is cut, because a cut changes vertices only.
///
/// A mesh does not change, and copies share its arrays.
class TriangleMesh
{
public:
  TriangleMesh()
    : TriangleMesh({}, {}, {})
  {
  }
  TriangleMesh(const TriangleMesh&) = default;
  TriangleMesh& operator=(const TriangleMesh&) = default;
  ~TriangleMesh() = default;
  // What is moved from stays a mesh.
  TriangleMesh(TriangleMesh&& other) noexcept { *this = std::as_const(other); }
  TriangleMesh& operator=(TriangleMesh&& other) noexcept { return *this = std::as_const(other); }
  /// \pre edges are manifold and triangles consistently oriented (see prepareSurface()).
  TriangleMesh(Points3 points, Triangles triangles);
  /// \param twins of the half-edges, where they are known.
  TriangleMesh(Points3 points, Triangles triangles, Indices twins);

  Index vertexCount() const { return static_cast<Index>(this->Shared->outgoing.size()); }
  Index triangleCount() const { return static_cast<Index>(this->Shared->cells.size()); }
  Index halfedgeCount() const { return static_cast<Index>(this->Shared->twins.size()); }

  const Points3& points() const { return this->Shared->points; }
  const Triangles& triangles() const { return this->Shared->cells; }
  const Indices& twins() const { return this->Shared->twins; }
  const Point3& point(Index vertex) const { return this->Shared->points[vertex]; }
  const Triangle& triangle(Index t) const { return this->Shared->cells[t]; }

  Index from(Index h) const { return this->Shared->cells[h / 3][h % 3]; }
  Index to(Index h) const { return this->from(next(h)); }
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  /// The same edge seen from the other side; none on the boundary.
  Index twin(Index h) const { return this->Shared->twins[h]; }
  /// A half-edge that leaves the vertex: on the boundary the one that has no twin, so that
  /// counterClockwise() from it visits the whole fan. none for an unused vertex.
  Index outgoing(Index vertex) const { return this->Shared->outgoing[vertex]; }
  /// The next half-edge that leaves from(h), counter-clockwise; none past the end of a boundary
  /// fan.
  Index counterClockwise(Index h) const { return this->Shared->twins[previous(h)]; }
  /// The half-edge from one vertex to another, none where the mesh has no such edge in this
  /// direction.
  Index find(Index fromVertex, Index toVertex) const;
  bool onBoundary(Index vertex) const;

  /// Whether the two are the same to the last bit.
  bool identical(const TriangleMesh& other) const;

  double length(Index h) const
  {
    return (this->point(this->to(h)) - this->point(this->from(h))).norm();
  }
  /// Interior angle of the triangle of h at from(h), in radians.
  double angle(Index h) const;
  Point3 centroid(Index t) const;
  double area(Index t) const;
  double area() const; ///< of all triangles

  /// Boundary loops as half-edges in order, the surface on their left; first the longest in length.
  std::vector<Indices> boundaryLoops() const;

private:
  struct Arrays
  {
    Points3 points;
    Triangles cells;
    Indices twins;
    Indices outgoing;
  };
  std::shared_ptr<const Arrays> Shared;
};

/// V - E + F of the mesh (vertices that no triangle uses do not count).
Index eulerCharacteristic(const TriangleMesh& mesh);

/// The parts of a surface that hang together, numbered by their first triangle. \param barred per
/// half-edge whether it divides; empty: none does. \return how many there are
Index connectedParts(
  const TriangleMesh& mesh, const std::vector<char>& barred, Indices& partOfTriangle);

/// Twice the area is the length of this vector, the orientation its direction.
inline Point3 areaVector(const Point3& a, const Point3& b, const Point3& c)
{
  return (b - a).cross(c - a);
}

inline Point3 areaVector(const Points3& points, const Triangle& t)
{
  return areaVector(points[t[0]], points[t[1]], points[t[2]]);
}

/// The unit normal of each vertex by the angles of its triangles, of length 0 where it has none
/// (J. A. Baerentzen, H. Aanaes, "Signed distance computation using the angle weighted
/// pseudonormal", 2005).
Points3 vertexNormals(const TriangleMesh& mesh);

/// A half-edge (3 t + k runs in triangle t from corner k) under its two vertices.
struct HalfedgeKey
{
  Index low = none;
  Index high = none;
  Index halfedge = none;
};

/// All half-edges of triangles, those of one edge next to each other in ascending order; by a
/// counting sort over the lower vertex, which takes linear time.
std::vector<HalfedgeKey> sortedSides(const Triangles& triangles, std::size_t vertexCount);

/// Per half-edge the other one of its edge; none where it is alone. \param sides as sorted.
Indices pairSides(const std::vector<HalfedgeKey>& sides);

/// The half-edges of each edge of more than two triangles, or of at least a number. \param sides as
/// sorted.
std::vector<Indices> crowdedEdges(const std::vector<HalfedgeKey>& sides, std::size_t least = 3);

/// As pairSides() in less time where the surface is in order: at most two triangles at an edge,
/// which run along it in opposite directions and have different third corners. Empty where it is
/// not, or where too many edges meet in a vertex to be quick.
Indices pairOrientedSides(const Triangles& triangles, std::size_t vertexCount);
}
