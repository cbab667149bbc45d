// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/EdgePaths.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

namespace flattening
{
EdgePaths::EdgePaths(
  const TriangleMesh& mesh, const Indices& starts, const std::vector<char>& barred, Through through)
  : Distance(mesh.vertexCount(), std::numeric_limits<double>::infinity())
  , Before(mesh.vertexCount(), none)
{
  using Reached = std::pair<double, Index>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
  for (Index start : starts)
  {
    this->Distance[start] = 0.0;
    this->Before[start] = start;
    front.emplace(0.0, start);
  }
  while (!front.empty())
  {
    const auto [distance, v] = front.top();
    front.pop();
    const bool bars =
      (through == Through::Inside && mesh.onBoundary(v)) || (!barred.empty() && barred[v] != 0);
    const bool ends = this->Before[v] != v && bars;
    if (distance > this->Distance[v] || ends)
    {
      continue;
    }
    for (Index h : VertexFan(mesh, v))
    {
      // Past the last half-edge of a boundary fan there is one more neighbour.
      for (Index edge : { h, TriangleMesh::previous(h) })
      {
        const Index w = edge == h ? mesh.to(edge) : mesh.from(edge);
        if (through == Through::Inside && mesh.twin(edge) == none)
        {
          continue;
        }
        const double further = distance + mesh.length(edge);
        if (further < this->Distance[w])
        {
          this->Distance[w] = further;
          this->Before[w] = v;
          front.emplace(further, w);
        }
      }
    }
  }
}

Indices EdgePaths::path(Index vertex) const
{
  Indices path{ vertex };
  while (this->Before[path.back()] != path.back())
  {
    path.push_back(this->Before[path.back()]);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

Index EdgePaths::farthest() const
{
  Index best = none;
  for (std::size_t v = 0; v < this->Before.size(); ++v)
  {
    const bool reached = this->Before[v] != none;
    if (reached && (best == none || this->Distance[v] > this->Distance[best]))
    {
      best = static_cast<Index>(v);
    }
  }
  return best;
}
}
