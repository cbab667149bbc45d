// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// The half-edges that leave a vertex, counter-clockwise, each once: for (Index h : VertexFan(mesh,
/// v)). On the boundary the first has no twin. Empty for a vertex that no triangle uses.
class VertexFan
{
public:
  class Iterator
  {
  public:
    Iterator(const TriangleMesh* mesh, Index first, Index h)
      : Mesh(mesh)
      , First(first)
      , Halfedge(h)
    {
    }
    Index operator*() const { return this->Halfedge; }
    Iterator& operator++()
    {
      const Index next = this->Mesh->counterClockwise(this->Halfedge);
      this->Halfedge = next == this->First ? none : next;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return this->Halfedge != other.Halfedge; }

  private:
    const TriangleMesh* Mesh;
    Index First;
    Index Halfedge; ///< none past the last
  };

  VertexFan(const TriangleMesh& mesh, Index vertex)
    : Mesh(&mesh)
    , First(mesh.outgoing(vertex))
  {
  }
  /// From another of its half-edges on; at a boundary vertex it ends at the boundary.
  static VertexFan startingAt(const TriangleMesh& mesh, Index halfedge)
  {
    VertexFan fan(mesh, mesh.from(halfedge));
    fan.First = halfedge;
    return fan;
  }
  Iterator begin() const { return { this->Mesh, this->First, this->First }; }
  Iterator end() const { return { this->Mesh, this->First, none }; }

private:
  const TriangleMesh* Mesh;
  Index First;
};

/// Sum of the angles of the triangles at a vertex, in radians; inside 2 pi where the surface is
/// flat.
inline double angleSum(const TriangleMesh& mesh, Index vertex)
{
  double sum = 0.0;
  for (Index h : VertexFan(mesh, vertex))
  {
    sum += mesh.angle(h);
  }
  return sum;
}

/// A third of the area of the triangles at a vertex.
inline double vertexArea(const TriangleMesh& mesh, Index vertex)
{
  double area = 0.0;
  for (Index h : VertexFan(mesh, vertex))
  {
    area += mesh.area(h / 3) / 3.0;
  }
  return area;
}

/// Per vertex a third of the areas of its triangles. \param areaOf gives that of a triangle.
template <class Area>
std::vector<double> vertexAreas(
  const Triangles& triangles, std::size_t vertexCount, const Area& areaOf)
{
  std::vector<double> areas(vertexCount, 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const double third = areaOf(static_cast<Index>(t)) / 3.0;
    for (Index v : triangles[t])
    {
      areas[v] += third;
    }
  }
  return areas;
}

/// Where a boundary turns by more it has a corner: half of what a hexagon turns by, so that coarse
/// round holes have none. In radians.
inline constexpr double cornerTurn = pi / 6.0;

/// By how much a boundary loop turns to its left in the surface, in radians: 2 pi around a flat
/// disk, -2 pi around a hole in it, 0 at the end of a cylinder.
inline double turnOf(const TriangleMesh& mesh, const Indices& loop)
{
  double turn = 0.0;
  for (Index h : loop)
  {
    turn += pi - angleSum(mesh, mesh.from(h));
  }
  return turn;
}
}
