// SPDX-License-Identifier: BSD-3-Clause
#include "Wires/WireNetwork.h"

#include "Base/CompressedRows.h"
#include "Cut/PieceTopology.h"
#include "Surface/TriangleMesh.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace flattening
{
namespace
{
/// Shortest paths from the wires that hang together to the next of the others, one after the other:
/// Prim's algorithm on Dijkstra's. What is joined becomes a source of the search, which goes on, so
/// that distances only fall; of equally short paths that is taken which a search from the start
/// would find.
class ConnectorSearch
{
public:
  explicit ConnectorSearch(const TriangleMesh& mesh)
    : Mesh(mesh)
    , Distance(mesh.vertexCount(), std::numeric_limits<double>::infinity())
    , Arrival(mesh.vertexCount(), none)
  {
  }

  void addSource(Index v)
  {
    this->Distance[v] = 0.0;
    this->Arrival[v] = none;
    this->Queue.push({ 0.0, v });
  }

  /// The half-edges to the nearest wire vertex that is no source, from there back; empty where
  /// there is none.
  Indices next(const std::vector<char>& onWire)
  {
    while (!this->Queue.empty())
    {
      const auto [d, v] = this->Queue.top();
      this->Queue.pop();
      if (d > this->Distance[v])
      {
        continue;
      }
      if (onWire[v] && d > 0.0)
      {
        return this->pathTo(v);
      }
      for (Index h : VertexFan(this->Mesh, v))
      {
        this->relax(h, v, this->Mesh.to(h));
        this->relax(TriangleMesh::previous(h), v, this->Mesh.from(TriangleMesh::previous(h)));
      }
    }
    return {};
  }

private:
  using Entry = std::pair<double, Index>;

  Index otherEnd(Index h, Index end) const
  {
    return this->Mesh.from(h) == end ? this->Mesh.to(h) : this->Mesh.from(h);
  }

  /// Whether the search comes to the source before the vertex from which the target is reached now.
  bool comesFirst(Index source, Index target) const
  {
    if (this->Arrival[target] == none)
    {
      return false; // a source itself
    }
    const Index before = this->otherEnd(this->Arrival[target], target);
    return Entry(this->Distance[source], source) < Entry(this->Distance[before], before);
  }

  void relax(Index h, Index source, Index target)
  {
    const double candidate = this->Distance[source] + this->Mesh.length(h);
    if (candidate < this->Distance[target])
    {
      this->Distance[target] = candidate;
      this->Arrival[target] = h;
      this->Queue.push({ candidate, target });
    }
    else if (candidate == this->Distance[target] && this->comesFirst(source, target))
    {
      this->Arrival[target] = h;
    }
  }

  Indices pathTo(Index v) const
  {
    Indices path;
    for (Index at = v; this->Arrival[at] != none; at = this->otherEnd(path.back(), at))
    {
      path.push_back(this->Arrival[at]);
    }
    return path;
  }

  const TriangleMesh& Mesh;
  std::vector<double> Distance;
  Indices Arrival;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
};

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
  /// their sides are; of equals, as on a tube, it is the longest.
  void putOuterLoopFirst()
  {
    std::size_t outer = 0;
    double most = turnOf(this->Mesh, this->BoundaryLoops.front());
    for (std::size_t k = 1; k < this->BoundaryLoops.size(); ++k)
    {
      const double turn = turnOf(this->Mesh, this->BoundaryLoops[k]);
      if (turn > most + 1e-6)
      {
        outer = k;
        most = turn;
      }
    }
    std::swap(this->BoundaryLoops.front(), this->BoundaryLoops[outer]);
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
    this->Network.patchCount = connectedParts(this->Mesh, this->IsWire, patch);
    this->FirstWireOfPatch.assign(this->Network.patchCount, none);
    for (Index h = 0; h < this->Mesh.halfedgeCount(); ++h)
    {
      Index& first = this->FirstWireOfPatch[patch[h / 3]];
      first = first == none && this->IsWire[h] ? h : first;
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

Indices findConnectors(const TriangleMesh& mesh, const std::vector<char>& isWire, Index root)
{
  JoinedSets components(mesh.vertexCount());
  std::vector<char> onWire(mesh.vertexCount(), 0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (isWire[h])
    {
      onWire[mesh.from(h)] = onWire[mesh.to(h)] = 1;
      components.join(mesh.from(h), mesh.to(h));
    }
  }
  const CompressedRows wires =
    groupMembers(static_cast<std::size_t>(mesh.vertexCount()), [&](const auto& visit) {
      for (Index v = 0; v < mesh.vertexCount(); ++v)
      {
        if (onWire[v])
        {
          visit(components.find(v), v);
        }
      }
    });
  Index apart = 0; // components that hang together with no other yet
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    apart += onWire[v] && components.find(v) == v ? 1 : 0;
  }
  ConnectorSearch search(mesh);
  std::vector<char> joined(mesh.vertexCount(), 0);
  const auto join = [&](Index component) {
    if (joined[component])
    {
      return;
    }
    joined[component] = 1;
    apart -= onWire[component] ? 1 : 0; // the vertex that stands for it is on it
    for (Index v : wires[component])
    {
      search.addSource(v);
    }
  };
  join(components.find(root));
  Indices connectors;
  while (apart > 0)
  {
    const Indices path = search.next(onWire);
    if (path.empty())
    {
      break;
    }
    for (Index h : path)
    {
      connectors.push_back(h);
      for (Index v : { mesh.from(h), mesh.to(h) })
      {
        join(components.find(v));
        onWire[v] = 1;
        search.addSource(v);
      }
    }
  }
  return connectors;
}

Indices hostDegrees(const WireNetwork& network)
{
  Indices degrees(network.hostVertices.size(), 0);
  for (const WireEdge& edge : network.edges)
  {
    ++degrees[network.hostOfVertex[edge.from]];
    ++degrees[network.hostOfVertex[edge.to]];
  }
  return degrees;
}

WireNetwork buildWireNetwork(const Piece& piece, bool disk)
{
  return Builder(piece).build(disk);
}
}
