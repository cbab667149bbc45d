// SPDX-License-Identifier: BSD-3-Clause
#include "Wires/WireNetwork.h"

#include "Base/CompressedRows.h"
#include "Cut/PieceTopology.h"
#include "Surface/VertexFan.h"
#include "Wires/WireConnectors.h"

#include <algorithm>
#include <utility>

namespace flattening
{
namespace
{
/// Builds the network of one piece step by step.
class Builder
{
public:
  explicit Builder(const Piece& piece)
    : Source(piece)
    , Mesh(piece.mesh)
    , IsWire(Mesh.halfedgeCount(), 0)
    , IsConnector(Mesh.halfedgeCount(), 0)
    , SideOfHalfedge(Mesh.halfedgeCount(), none)
  {
  }

  WireNetwork build(bool disk)
  {
    if (!disk)
    {
      this->Network.status = refusalOf({ findDefect(this->Source) });
    }
    if (!this->Network.status.ok())
    {
      return std::move(this->Network);
    }
    this->BoundaryLoops = this->Mesh.boundaryLoops();
    this->Network.boundaryLoops = static_cast<Index>(this->BoundaryLoops.size());
    this->putOuterLoopFirst();
    this->markWires();
    this->findPatches();
    for (Index patch = 0; patch < this->Network.patchCount; ++patch)
    {
      this->addPatchLoop(patch);
    }
    for (std::size_t k = 1; k < this->BoundaryLoops.size(); ++k)
    {
      this->addHoleLoop(this->BoundaryLoops[k]);
    }
    this->Network.loopBegin.push_back(this->Network.nodeCount());
    this->addEdges();
    this->collectHosts();
    this->completeHoleAngles();
    return std::move(this->Network);
  }

private:
  /// The outer boundary turns by about 2 pi around the surface, holes by about -2 pi, however long
  /// their banks are; of equals, as on a tube, it is the longest.
  void putOuterLoopFirst()
  {
    std::size_t outer = 0;
    double most = this->turning(this->BoundaryLoops.front());
    for (std::size_t k = 1; k < this->BoundaryLoops.size(); ++k)
    {
      const double turn = this->turning(this->BoundaryLoops[k]);
      if (turn > most + 1e-6)
      {
        outer = k;
        most = turn;
      }
    }
    std::swap(this->BoundaryLoops.front(), this->BoundaryLoops[outer]);
  }

  double turning(const Indices& loop) const
  {
    double sum = 0.0;
    for (Index first : loop)
    {
      sum += pi;
      for (Index h : VertexFan(this->Mesh, this->Mesh.from(first)))
      {
        sum -= this->Mesh.angle(h);
      }
    }
    return sum;
  }

  void markWires()
  {
    for (Index h = 0; h < this->Mesh.halfedgeCount(); ++h)
    {
      this->IsWire[h] = this->Mesh.twin(h) == none || this->Source.curveOfHalfedge[h] != none;
    }
    const Index root = this->Mesh.from(this->BoundaryLoops.front().front());
    for (Index h : findConnectors(this->Mesh, this->IsWire, root))
    {
      this->IsWire[h] = this->IsConnector[h] = 1;
      const Index twin = this->Mesh.twin(h);
      if (twin != none)
      {
        this->IsWire[twin] = this->IsConnector[twin] = 1;
      }
    }
  }

  void findPatches()
  {
    Indices& patch = this->Network.patchOfTriangle;
    patch.assign(this->Mesh.triangleCount(), none);
    Indices stack;
    for (Index seed = 0; seed < this->Mesh.triangleCount(); ++seed)
    {
      if (patch[seed] != none)
      {
        continue;
      }
      Index firstWire = none;
      patch[seed] = this->Network.patchCount;
      stack.push_back(seed);
      while (!stack.empty())
      {
        const Index t = stack.back();
        stack.pop_back();
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
        {
          if (this->IsWire[h])
          {
            firstWire = firstWire == none ? h : std::min(firstWire, h);
          }
          else if (patch[this->Mesh.twin(h) / 3] == none)
          {
            patch[this->Mesh.twin(h) / 3] = this->Network.patchCount;
            stack.push_back(this->Mesh.twin(h) / 3);
          }
        }
      }
      this->FirstWireOfPatch.push_back(firstWire);
      ++this->Network.patchCount;
    }
  }

  void beginLoop(Index patch)
  {
    this->Network.loopBegin.push_back(this->Network.nodeCount());
    this->Network.patchOfLoop.push_back(patch);
  }

  void addSide(Index vertex, Index halfedge, double alpha)
  {
    this->Network.vertex.push_back(vertex);
    this->Network.halfedge.push_back(halfedge);
    this->Network.alpha.push_back(alpha);
    this->Network.loop.push_back(this->Network.loopCount() - 1);
  }

  void endLoop()
  {
    const Index begin = this->Network.loopBegin.back();
    const Index end = this->Network.nodeCount();
    for (Index i = begin; i < end; ++i)
    {
      this->Network.previous.push_back(i == begin ? end - 1 : i - 1);
      this->Network.next.push_back(i + 1 == end ? begin : i + 1);
    }
  }

  /// Walks with the patch on the left; the angle of a node is what the walk sweeps over at its
  /// vertex.
  void addPatchLoop(Index patch)
  {
    this->beginLoop(patch);
    const Index start = this->FirstWireOfPatch[patch];
    Index h = start;
    do
    {
      Index outgoing = TriangleMesh::next(h);
      double alpha = this->Mesh.angle(outgoing);
      while (!this->IsWire[outgoing])
      {
        outgoing = TriangleMesh::next(this->Mesh.twin(outgoing));
        alpha += this->Mesh.angle(outgoing);
      }
      this->SideOfHalfedge[outgoing] = this->Network.nodeCount();
      this->addSide(this->Mesh.from(outgoing), outgoing, alpha);
      h = outgoing;
    } while (h != start);
    this->endLoop();
  }

  /// From inside a hole its edges run the other way and in the opposite order.
  void addHoleLoop(const Indices& loop)
  {
    this->beginLoop(none);
    for (auto h = loop.rbegin(); h != loop.rend(); ++h)
    {
      this->HoleSides.emplace_back(*h, this->Network.nodeCount());
      this->addSide(this->Mesh.to(*h), none, 0.0);
    }
    this->endLoop();
  }

  void addEdges()
  {
    WireNetwork& net = this->Network;
    net.edge.assign(net.nodeCount(), none);
    net.twin.assign(net.nodeCount(), none);
    for (const auto& [halfedge, side] : this->HoleSides)
    {
      net.twin[side] = this->SideOfHalfedge[halfedge];
      net.twin[this->SideOfHalfedge[halfedge]] = side;
    }
    for (Index side = 0; side < net.nodeCount(); ++side)
    {
      const Index h = net.halfedge[side];
      if (h != none && this->Mesh.twin(h) != none)
      {
        net.twin[side] = this->SideOfHalfedge[this->Mesh.twin(h)];
      }
    }
    for (Index side = 0; side < net.nodeCount(); ++side)
    {
      if (net.edge[side] != none)
      {
        continue;
      }
      const Index h = net.halfedge[side];
      WireEdge edge;
      edge.from = net.vertex[side];
      edge.to = net.endVertex(side);
      edge.side = side;
      edge.otherSide = net.twin[side];
      edge.curve = this->Source.curveOfHalfedge[h];
      edge.connector = this->IsConnector[h] != 0;
      edge.length = this->Mesh.length(h);
      net.edge[side] = net.edgeCount();
      if (edge.otherSide != none)
      {
        net.edge[edge.otherSide] = net.edgeCount();
      }
      net.edges.push_back(edge);
    }
  }

  void collectHosts()
  {
    WireNetwork& net = this->Network;
    net.hostOfVertex.assign(this->Mesh.vertexCount(), none);
    for (Index i = 0; i < net.nodeCount(); ++i)
    {
      Index& host = net.hostOfVertex[net.vertex[i]];
      if (host == none)
      {
        host = static_cast<Index>(net.hostVertices.size());
        net.hostVertices.push_back(net.vertex[i]);
      }
    }
    CompressedRows nodes = groupMembers(net.hostVertices.size(), [&net](const auto& visit) {
      for (Index i = 0; i < net.nodeCount(); ++i)
      {
        visit(net.hostOfVertex[net.vertex[i]], i);
      }
    });
    net.vertexNodeBegin = std::move(nodes.begin);
    net.vertexNodes = std::move(nodes.members);
    net.interior.assign(net.hostVertices.size(), 1);
    for (Index h : this->BoundaryLoops.front())
    {
      net.interior[net.hostOfVertex[this->Mesh.from(h)]] = 0;
    }
  }

  void completeHoleAngles()
  {
    WireNetwork& net = this->Network;
    for (const auto& entry : this->HoleSides)
    {
      const Index node = entry.second;
      const Index host = net.hostOfVertex[net.vertex[node]];
      double rest = 2.0 * pi;
      for (Index k = net.vertexNodeBegin[host]; k < net.vertexNodeBegin[host + 1]; ++k)
      {
        rest -= net.vertexNodes[k] == node ? 0.0 : net.alpha[net.vertexNodes[k]];
      }
      net.alpha[node] = rest;
    }
  }

  const Piece& Source;
  const TriangleMesh& Mesh;
  std::vector<char> IsWire;
  std::vector<char> IsConnector;
  Indices SideOfHalfedge;
  std::vector<std::pair<Index, Index>> HoleSides; ///< boundary half-edge, side in the hole
  std::vector<Indices> BoundaryLoops;
  Indices FirstWireOfPatch;
  WireNetwork Network;
};
}

WireNetwork buildWireNetwork(const Piece& piece, bool disk)
{
  return Builder(piece).build(disk);
}
}
