// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfacePoint.h"

namespace flattening
{
/// Short ways from vertex to vertex: along an edge, or straight across one to the vertex on its
/// other side. What starts of paths are sought in; made once for a surface.
class PathGraph
{
public:
  struct Way
  {
    Index vertex = none;  ///< that it leads to
    Index crossed = none; ///< the half-edge that it crosses; none along an edge
    double length = 0.0;
  };
  struct Ways
  {
    const Way* first;
    const Way* last;
    const Way* begin() const { return this->first; }
    const Way* end() const { return this->last; }
  };

  /// The mesh must outlive the graph.
  explicit PathGraph(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return this->Mesh; }
  /// For sections of the surface that go through vertices only where they meet them.
  const SnapDistance& noSnap() const { return this->NoSnap; }
  Ways from(Index vertex) const
  {
    return { this->All.data() + this->Begin[vertex], this->All.data() + this->Begin[vertex + 1] };
  }

private:
  const TriangleMesh& Mesh;
  SnapDistance NoSnap;
  std::vector<std::size_t> Begin;
  std::vector<Way> All;
};
}
