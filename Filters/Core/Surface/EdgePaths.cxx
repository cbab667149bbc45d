// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/EdgePaths.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

namespace flattening
{
EdgePaths::EdgePaths(const TriangleMesh& mesh, const Indices& starts,
  const std::vector<char>& barred, Through through, const std::vector<double>& lengths)
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
        const double further = distance + (lengths.empty() ? mesh.length(edge) : lengths[edge]);
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

std::vector<Indices> joiningPaths(
  const TriangleMesh& mesh, std::vector<Indices> loops, const std::vector<char>& barred)
{
  const auto isFree = [&](Index v) { return barred.empty() || !barred[v]; };
  Indices joined;
  const auto join = [&](std::size_t l) {
    for (Index h : loops[l])
    {
      if (isFree(mesh.from(h)))
      {
        joined.push_back(mesh.from(h));
      }
    }
    loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(l));
  };
  std::vector<Indices> found;
  if (loops.size() > 1)
  {
    join(0);
  }
  while (!joined.empty() && !loops.empty())
  {
    const EdgePaths paths(mesh, joined, barred);
    std::size_t nearest = 0;
    Index end = none;
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      for (Index h : loops[l])
      {
        const Index v = mesh.from(h);
        if (isFree(v) && (end == none || paths.distance(v) < paths.distance(end)))
        {
          end = v;
          nearest = l;
        }
      }
    }
    if (end == none || !paths.reaches(end))
    {
      break;
    }
    found.push_back(paths.path(end));
    join(nearest);
  }
  return found;
}
}
