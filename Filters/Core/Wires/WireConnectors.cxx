// SPDX-License-Identifier: BSD-3-Clause
#include "Wires/WireConnectors.h"

#include "Base/CompressedRows.h"
#include "Surface/VertexFan.h"

#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace flattening
{
namespace
{
class Components
{
public:
  explicit Components(Index count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  Index find(Index v)
  {
    while (this->Parent[v] != v)
    {
      v = this->Parent[v] = this->Parent[this->Parent[v]];
    }
    return v;
  }
  void join(Index a, Index b) { this->Parent[this->find(a)] = this->find(b); }

private:
  Indices Parent;
};

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
}

Indices findConnectors(const TriangleMesh& mesh, const std::vector<char>& isWire, Index root)
{
  Components components(mesh.vertexCount());
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
}
