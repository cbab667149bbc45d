// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/SurfacePoint.h"

namespace flattening
{
/// Arcs from vertex to vertex of a mesh: along an edge, or straight across one to the vertex on its
/// other side. Searches of paths run on them; made once for a surface.
///
/// Lengths are whole numbers kept as doubles. Their sums are exact, so that paths of equal length
/// compare as equal in every unit, in whatever order their arcs are added.
class PathGraph
{
public:
  struct Arc
  {
    Index to = none;      ///< vertex
    Index crossed = none; ///< the half-edge that it crosses; none along an edge
    double length = 0.0;  ///< rounded()
  };
  struct Arcs
  {
    const Arc* first;
    const Arc* last;
    const Arc* begin() const { return this->first; }
    const Arc* end() const { return this->last; }
  };

  /// The mesh must outlive the graph.
  explicit PathGraph(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return this->Mesh; }
  /// For sections of the surface that go through vertices only where they meet them.
  const SnapDistance& noSnap() const { return this->NoSnap; }
  Arcs from(Index vertex) const
  {
    return { this->All.data() + this->Begin[vertex], this->All.data() + this->Begin[vertex + 1] };
  }
  /// A length as a whole number of the graph's units, at least 1.
  double rounded(double length) const;
  /// The straight line from a vertex to a point in the graph's units, not rounded.
  double straight(Index vertex, const Point3& point) const
  {
    return (this->Mesh.point(vertex) - point).norm() * this->Scale;
  }

private:
  const TriangleMesh& Mesh;
  SnapDistance NoSnap;
  double Scale = 1.0; ///< the graph's units in a unit of length
  std::vector<std::size_t> Begin;
  std::vector<Arc> All;
};
}
