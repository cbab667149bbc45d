// SPDX-License-Identifier: BSD-3-Clause
#include "Wires/WireConnectors.h"

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

/// Shortest path from the vertices marked as sources to the nearest wire vertex of another
/// component.
Indices shortestPath(const TriangleMesh& mesh, const std::vector<char>& onWire,
  Components& components, Index rootComponent)
{
  using Entry = std::pair<double, Index>;
  const double far = std::numeric_limits<double>::infinity();
  std::vector<double> distance(mesh.vertexCount(), far);
  Indices arrival(mesh.vertexCount(), none);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (onWire[v] && components.find(v) == rootComponent)
    {
      distance[v] = 0.0;
      queue.push({ 0.0, v });
    }
  }
  auto relax = [&](Index h, Index source, Index target, double d) {
    const double candidate = d + mesh.length(h);
    if (distance[source] == d && candidate < distance[target])
    {
      distance[target] = candidate;
      arrival[target] = h;
      queue.push({ candidate, target });
    }
  };
  while (!queue.empty())
  {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v])
    {
      continue;
    }
    if (onWire[v] && d > 0.0)
    {
      Indices path;
      for (Index at = v; arrival[at] != none;)
      {
        const Index h = arrival[at];
        path.push_back(h);
        at = mesh.from(h) == at ? mesh.to(h) : mesh.from(h);
      }
      return path;
    }
    for (Index h : VertexFan(mesh, v))
    {
      relax(h, v, mesh.to(h), d);
      relax(TriangleMesh::previous(h), v, mesh.from(TriangleMesh::previous(h)), d);
    }
  }
  return {};
}
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
  Index separate = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    separate += onWire[v] && components.find(v) == v ? 1 : 0;
  }
  Indices connectors;
  for (; separate > 1; --separate)
  {
    const Indices path = shortestPath(mesh, onWire, components, components.find(root));
    for (Index h : path)
    {
      connectors.push_back(h);
      onWire[mesh.from(h)] = onWire[mesh.to(h)] = 1;
      components.join(mesh.from(h), mesh.to(h));
    }
  }
  return connectors;
}
}
