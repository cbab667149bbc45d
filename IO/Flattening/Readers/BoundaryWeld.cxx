// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryWeld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace wirewarp
{
namespace
{
using Edge = std::pair<std::int64_t, std::int64_t>;

double distanceOf(const TriangleList& list, std::int64_t p, std::int64_t q)
{
  return (list.point(p) - list.point(q)).norm();
}

/// Some of the points, to be found by their places in a grid.
class PlacedPoints
{
public:
  /// \param farthest distance within which near() will look
  PlacedPoints(const TriangleList& list, const std::vector<std::int64_t>& ids, double farthest)
    : List(list)
    , Width(farthest > 0.0 ? farthest : 1.0)
  {
    for (const std::int64_t p : ids)
    {
      this->Cells[this->cellOf(list.point(p))].push_back(p);
    }
  }

  /// Those within a distance of one of them, itself among them, in the order of their ids.
  std::vector<std::pair<std::int64_t, double>> near(std::int64_t p, double distance) const
  {
    std::vector<std::pair<std::int64_t, double>> points;
    const Cell center = this->cellOf(this->List.point(p));
    for (int k = 0; k < 27; ++k)
    {
      const int row = k / 3 % 3;
      const int layer = k / 9;
      const auto found =
        this->Cells.find({ center[0] + k % 3 - 1, center[1] + row - 1, center[2] + layer - 1 });
      for (const std::int64_t q :
        found == this->Cells.end() ? std::vector<std::int64_t>() : found->second)
      {
        const double away = distanceOf(this->List, p, q);
        if (away <= distance)
        {
          points.emplace_back(q, away);
        }
      }
    }
    std::sort(points.begin(), points.end());
    return points;
  }

private:
  using Cell = std::array<double, 3>;

  Cell cellOf(const Point3& x) const
  {
    return { std::floor(x[0] / this->Width), std::floor(x[1] / this->Width),
      std::floor(x[2] / this->Width) };
  }

  const TriangleList& List;
  double Width;
  std::map<Cell, std::vector<std::int64_t>> Cells;
};
}

WeldedPoints weldBoundary(TriangleList& list, double coincident, double distance)
{
  const std::vector<std::int64_t> boundary = boundaryPoints(list);
  WeldedPoints welded;
  if (boundary.empty())
  {
    return welded;
  }
  std::set<Edge> edges;
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (std::size_t k = 0; k < 3 && distance > coincident; ++k)
    {
      edges.insert(std::minmax(triangle.corners[k], triangle.corners[(k + 1) % 3]));
    }
  }
  const PlacedPoints placed(list, boundary, std::max(coincident, distance));
  std::unordered_map<std::int64_t, std::int64_t> joined;
  std::unordered_map<std::int64_t, std::vector<std::int64_t>> members; // of each point that is kept
  for (const std::int64_t p : boundary)
  {
    std::pair<double, std::int64_t> nearest{ std::numeric_limits<double>::infinity(), p };
    for (const auto& [q, away] : placed.near(p, std::max(coincident, distance)))
    {
      const auto cluster = members.find(q);
      if (cluster == members.end() || away >= nearest.first)
      {
        continue;
      }
      const std::vector<std::int64_t>& points = cluster->second;
      if (away <= coincident || std::none_of(points.begin(), points.end(), [&, p](std::int64_t m) {
            return edges.count(std::minmax(p, m)) > 0;
          }))
      {
        nearest = { away, q };
      }
    }
    members[nearest.second].push_back(p);
    if (nearest.second != p)
    {
      joined[p] = nearest.second;
      welded.farthest = std::max(welded.farthest, nearest.first);
    }
  }
  for (ListedTriangle& triangle : list.triangles)
  {
    for (std::int64_t& corner : triangle.corners)
    {
      const auto to = joined.find(corner);
      corner = to == joined.end() ? corner : to->second;
    }
  }
  welded.count = joined.size();
  return welded;
}

UnjoinedBoundary unjoinedEdges(
  const TriangleList& list, const std::vector<BoundaryLoop>& loops, double coincident, double near)
{
  std::set<Edge> edges;
  std::map<std::int64_t, double> shortest; // edge at a point
  for (const BoundaryLoop& loop : loops)
  {
    for (std::size_t k = 0; k < loop.points.size(); ++k)
    {
      const Edge edge = std::minmax(loop.points[k], loop.points[(k + 1) % loop.points.size()]);
      const double length = distanceOf(list, edge.first, edge.second);
      edges.insert(edge);
      for (const std::int64_t p : { edge.first, edge.second })
      {
        const auto at = shortest.emplace(p, length).first;
        at->second = std::min(at->second, length);
      }
    }
  }
  UnjoinedBoundary unjoined;
  if (edges.empty())
  {
    return unjoined;
  }
  std::vector<std::int64_t> ids;
  for (const auto& [p, length] : shortest)
  {
    ids.push_back(p);
  }
  const PlacedPoints placed(list, ids, std::max(coincident, near));
  std::map<std::int64_t, std::vector<std::pair<std::int64_t, double>>> partners;
  for (const auto& [p, length] : shortest)
  {
    partners[p] = placed.near(p, std::max(coincident, std::min(near, 0.1 * length)));
  }
  for (const Edge& edge : edges)
  {
    double gap = std::numeric_limits<double>::infinity();
    for (const auto& [a, distanceA] : partners[edge.first])
    {
      for (const auto& [b, distanceB] : partners[edge.second])
      {
        const double distance = std::max(distanceA, distanceB);
        // Beside a tip, which its sides share, a cut is narrow by nature.
        const bool apart = a != edge.first && b != edge.second;
        const Edge other = std::minmax(a, b);
        if ((apart || distance <= coincident) && other != edge && edges.count(other) > 0)
        {
          gap = std::min(gap, distance);
        }
      }
    }
    if (std::isfinite(gap))
    {
      UnjoinedEdges& found = gap <= coincident ? unjoined.coincident : unjoined.near;
      found.point = found.count == 0 ? edge.first : std::min(found.point, edge.first);
      found.gap = std::max(found.gap, gap);
      ++found.count;
    }
  }
  return unjoined;
}
}
