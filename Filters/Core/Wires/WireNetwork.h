// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Surface/FeatureCurve.h"

namespace flattening
{
/// One edge of a wire. Its length is kept in the plane.
struct WireEdge
{
  Index from = none;      ///< piece vertex
  Index to = none;        ///< piece vertex
  Index side = none;      ///< the side that runs from `from` to `to`
  Index otherSide = none; ///< the side that runs back; none on the outer boundary
  Index curve = none;     ///< feature curve; none on the boundary of the surface and on connectors
  bool connector = false; ///< joins a loop to the rest; its length is free
  double length = 0.0;    ///< on the surface
};

/// The wires of one piece and the wire-patches that they enclose (Definitions 4 to 6).
///
/// A wire-patch's boundary is a loop of sides, anti-clockwise; side i runs along a wire edge with
/// the patch on its left, and wire-node i stands where side i starts, between side previous[i] and
/// side i. A wire edge inside the piece thus has two sides, one in each neighbouring patch, and the
/// tip of a wire that ends inside a patch has one node, whose angle goes all the way round. The
/// loop around a hole of the piece is a face too, without triangles, so that the wires around it
/// meet in the plane; only the outer boundary has nothing on its other side.
struct WireNetwork
{
  // One entry a side and its node.
  Indices vertex;   ///< host vertex of the node, where the side starts
  Indices previous; ///< in the loop
  Indices next;     ///< in the loop
  Indices loop;
  Indices edge;
  Indices twin;     ///< the other side of the edge; none on the outer boundary
  Indices halfedge; ///< of the piece's mesh; none on the loop around a hole
  std::vector<double>
    alpha; ///< surface angle of the node; around a hole 2 pi less the others there

  std::vector<WireEdge> edges;

  /// Loop k owns the sides loopBegin[k] .. loopBegin[k + 1] - 1, in order.
  Indices loopBegin;
  /// Per loop the wire-patch inside it; none for the loop around a hole.
  Indices patchOfLoop;
  Indices patchOfTriangle;
  Index patchCount = 0;

  /// Host vertices of nodes, and the nodes of each: vertexNodes[vertexNodeBegin[k] ..
  /// vertexNodeBegin[k + 1] - 1] belong to hostVertices[k].
  Indices hostVertices;
  Indices vertexNodeBegin;
  Indices vertexNodes;
  /// Per host vertex: its angles must sum to 2 pi (it is not on the outer boundary).
  std::vector<char> interior;
  /// Per piece vertex its place in hostVertices, else none.
  Indices hostOfVertex;

  /// Of the piece, the outer boundary and holes.
  Index boundaryLoops = 0;

  Status status;

  Index nodeCount() const { return static_cast<Index>(this->vertex.size()); }
  Index edgeCount() const { return static_cast<Index>(this->edges.size()); }
  Index loopCount() const { return static_cast<Index>(this->patchOfLoop.size()); }
  Index endVertex(Index side) const { return this->vertex[this->next[side]]; }
  double length(Index side) const { return this->edges[this->edge[side]].length; }
  /// The side runs from its edge's `from` to its `to`, not back.
  bool alongEdge(Index side) const { return this->edges[this->edge[side]].side == side; }
  bool isHole(Index loopId) const { return this->patchOfLoop[loopId] == none; }
};

/// Finds wires, nodes, loops and patches of one piece.
///
/// Boundary loops and wires that are not joined to the outer boundary are joined to it by
/// connectors along shortest paths of mesh edges. \param disk that the piece has a boundary and no
/// handles is known. Errors, where it is not: ClosedSurface, Handle (ids: triangles).
WireNetwork buildWireNetwork(const Piece& piece, bool disk = false);

/// Per host vertex how many wire edges end there.
Indices hostDegrees(const WireNetwork& network);

/// Edges to add as wires so that all wires hang together: shortest paths of mesh edges from the
/// wires that are joined to the given root vertex to the others, nearest first.
/// \param isWire per half-edge, both sides of an edge alike. \return half-edges.
Indices findConnectors(const TriangleMesh& mesh, const std::vector<char>& isWire, Index root);
}
