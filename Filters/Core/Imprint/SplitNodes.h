// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/EdgeNodes.h"
#include "Imprint/ImprintedSurface.h"

#include <map>
#include <tuple>

namespace flattening
{
/// The vertices of a mesh that is split: those of the mesh before, with their ids, and the nodes
/// after them, which lie on its edges and inside its triangles.
class SplitNodes
{
public:
  struct Place
  {
    Index node;
    bool isNew;
  };

  /// Mesh and distance stay the caller's and must outlive the nodes.
  SplitNodes(const TriangleMesh& mesh, const SnapDistance& snap);

  /// The node of a point of the surface: the one already there, or one within the snap distance on
  /// the same edge, or a new one.
  Place place(const SurfacePoint& point);
  /// A node inside a triangle where there is none yet.
  Index add(const SurfacePoint& point);
  /// Makes one node of two; `into` stays.
  void merge(Index node, Index into);

  SurfacePoint point(Index node) const;
  /// The nodes of an edge in the direction of a half-edge.
  std::vector<NodeOnEdge> along(Index halfedge) const
  {
    return this->OnEdge.along(this->Mesh, halfedge);
  }

  /// Numbers what is left of the nodes, once all are there.
  std::vector<VertexSource> numberVertices();
  /// \pre numberVertices() was called.
  Index vertex(Index node) const;

private:
  const TriangleMesh& Mesh;
  const SnapDistance& Snap;
  Index VertexCount;
  std::vector<SurfacePoint> Nodes; ///< those after the vertices
  Indices Alias;                   ///< the node that a node became one with
  Indices VertexOfNode;
  EdgeNodes OnEdge;
  std::map<std::tuple<Carrier, Index, std::array<double, 3>>, Index> Known;
};
}
