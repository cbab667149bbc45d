// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfacePoint.h"

namespace flattening
{
struct NodeOnEdge
{
  double fraction; ///< from the start of the half-edge
  Index node;
};

/// The points put on edges of a mesh, in order along each edge. Edges are named by edgeOf().
class EdgeNodes
{
public:
  /// The node next to a place on an edge, none within the distance (a fraction of the edge).
  Index nearest(Index edge, double fraction, double distance) const;
  void insert(Index edge, double fraction, Index node);
  /// The nodes of an edge in the direction of a half-edge.
  std::vector<NodeOnEdge> along(const TriangleMesh& mesh, Index halfedge) const;

private:
  std::unordered_map<Index, std::vector<NodeOnEdge>> Nodes;
};
}
