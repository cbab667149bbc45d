// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfacePoint.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace flattening
{
/// Lengths of ways as whole numbers: sums of them are exact, so that ways that are equally long are
/// so in every unit, and whichever way they are found.
using WayLength = std::uint64_t;

inline constexpr std::size_t landmarkCount = 16;
/// See landmarkDistances().
using LandmarkDistances = std::array<WayLength, landmarkCount>;

/// Short ways from vertex to vertex: along an edge, or straight across one to the vertex on its
/// other side. What starts of paths are sought in; made once for a surface.
///
/// Its nodes are the vertices in an order in which neighbours are near each other in memory,
/// however the mesh numbers them: a search waits for memory most of its time.
class PathGraph
{
public:
  struct Way
  {
    Index node = none;    ///< that it leads to
    Index crossed = none; ///< the half-edge that it crosses; none along an edge
    WayLength length = 0;
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
  Index nodeCount() const { return static_cast<Index>(this->Vertices.size()); }
  Index vertex(Index node) const { return this->Vertices[node]; }
  Index node(Index vertex) const { return this->Nodes[vertex]; }
  const Point3& position(Index node) const { return this->Positions[node]; }
  Ways from(Index node) const
  {
    return { this->All.data() + this->Begin[node], this->All.data() + this->Begin[node + 1] };
  }
  /// Lets searches look ahead by them; which ways they find does not change.
  void setLandmarks(std::vector<LandmarkDistances> distances);
  /// Of a node; null where there are none.
  const LandmarkDistances* landmarks(Index node) const
  {
    return this->Landmarks.empty() ? nullptr : &this->Landmarks[node];
  }
  /// A length rounded to a whole number, at least 1.
  WayLength rounded(double length) const;
  /// From a node to a point through the air: no way is shorter, but for the last digits of its
  /// parts.
  WayLength straight(Index node, const Point3& point) const
  {
    // Parts of a surface may lie farther from each other than all ways go.
    return static_cast<WayLength>(
      std::min((this->Positions[node] - point).norm() * this->Scale, sumOfAll));
  }

private:
  /// What all ways together come to at most, so that no sum of some runs over.
  static constexpr double sumOfAll = 0x1p61;

  const TriangleMesh& Mesh;
  SnapDistance NoSnap;
  double Scale = 1.0; ///< whole numbers in a unit of length
  Indices Vertices;   ///< by node
  Indices Nodes;      ///< by vertex
  Points3 Positions;  ///< by node
  std::vector<std::size_t> Begin;
  std::vector<Way> All;
  std::vector<LandmarkDistances> Landmarks; ///< by node, or none
};
}
