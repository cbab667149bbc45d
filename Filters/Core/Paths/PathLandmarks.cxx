// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathLandmarks.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

namespace flattening
{
namespace
{
constexpr WayLength notReached = std::numeric_limits<WayLength>::max();

/// The nodes that a node is joined with, itself included, the farthest last (E. W. Dijkstra, 1959).
/// \param distances not reached for all of these
Indices nodesFrom(const PathGraph& graph, Index start, std::vector<WayLength>& distances)
{
  using Entry = std::pair<WayLength, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  Indices settled;
  distances[start] = 0;
  queue.emplace(0, start);
  while (!queue.empty())
  {
    const auto [distance, node] = queue.top();
    queue.pop();
    if (distance > distances[node])
    {
      continue;
    }
    settled.push_back(node);
    for (const PathGraph::Way& way : graph.from(node))
    {
      const WayLength length = distance + way.length;
      if (length < distances[way.node])
      {
        distances[way.node] = length;
        queue.emplace(length, way.node);
      }
    }
  }
  return settled;
}

Indices largestPart(const PathGraph& graph)
{
  std::vector<WayLength> distances(graph.nodeCount(), notReached);
  Indices largest;
  for (Index node = 0; node < graph.nodeCount(); ++node)
  {
    if (distances[node] == notReached)
    {
      Indices part = nodesFrom(graph, node, distances);
      if (part.size() > largest.size())
      {
        largest = std::move(part);
      }
    }
  }
  return largest;
}
}

std::vector<LandmarkDistances> landmarkDistances(const PathGraph& graph)
{
  std::vector<LandmarkDistances> all(graph.nodeCount(), LandmarkDistances{});
  const Indices part = largestPart(graph);
  std::vector<WayLength> toNearest(graph.nodeCount(), notReached);
  std::vector<WayLength> distances;
  Index landmark = part.empty() ? none : part.back();
  for (std::size_t k = 0; k < landmarkCount && landmark != none; ++k)
  {
    distances.assign(graph.nodeCount(), notReached);
    nodesFrom(graph, landmark, distances);
    for (const Index node : part)
    {
      all[node][k] = distances[node];
      toNearest[node] = std::min(toNearest[node], distances[node]);
    }
    landmark = *std::max_element(
      part.begin(), part.end(), [&](Index a, Index b) { return toNearest[a] < toNearest[b]; });
  }
  return all;
}
}
