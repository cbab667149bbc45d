// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/VertexMatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace flattening
{
namespace
{
using Cell = std::array<std::int64_t, 3>;

struct CellHash
{
  std::size_t operator()(const Cell& cell) const
  {
    std::uint64_t hash = 0;
    for (std::int64_t k : cell)
    {
      hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15ull;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

class QueryGrid
{
public:
  QueryGrid(const Eigen::AlignedBox3d& bounds, double radius, std::size_t queryCount)
    : Origin(bounds.min())
    // Balls of one radius touch eight cells at most; the floor keeps cell numbers in range.
    , Size(std::max(2.0 * radius, 1e-9 * bounds.diagonal().norm()))
  {
    std::size_t places = 1024;
    while (places < 32 * queryCount)
    {
      places *= 2;
    }
    this->Occupied.assign(places, 0);
  }

  void insert(Index query, const Point3& point, double radius)
  {
    const Cell low = this->cell(point - Point3::Constant(radius));
    const Cell high = this->cell(point + Point3::Constant(radius));
    for (std::int64_t i = low[0]; i <= high[0]; ++i)
    {
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
      {
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
        {
          const Cell cell{ i, j, k };
          this->Occupied[this->placeOf(cell)] = 1;
          this->Queries[cell].push_back(query);
        }
      }
    }
  }

  const Indices* near(const Point3& point) const
  {
    const Cell cell = this->cell(point);
    if (!this->Occupied[this->placeOf(cell)])
    {
      return nullptr;
    }
    const auto found = this->Queries.find(cell);
    return found == this->Queries.end() ? nullptr : &found->second;
  }

private:
  Cell cell(const Point3& point) const
  {
    const Point3 c = (point - this->Origin) / this->Size;
    return { roundDown(c.x()), roundDown(c.y()), roundDown(c.z()) };
  }

  static std::int64_t roundDown(double x)
  {
    const auto towardsZero = static_cast<std::int64_t>(x);
    return x < static_cast<double>(towardsZero) ? towardsZero - 1 : towardsZero;
  }

  std::size_t placeOf(const Cell& cell) const
  {
    return CellHash()(cell) & (this->Occupied.size() - 1);
  }

  Point3 Origin;
  double Size;
  std::unordered_map<Cell, Indices, CellHash> Queries;
  std::vector<char> Occupied; ///< by hash of a cell: most vertices are near no query
};
}

std::vector<Indices> matchVertices(const TriangleMesh& mesh, const Points3& queries, double radius)
{
  std::vector<Indices> nearest(queries.size());
  Eigen::AlignedBox3d bounds;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.outgoing(v) != none)
    {
      bounds.extend(mesh.point(v));
    }
  }
  if (bounds.isEmpty() || queries.empty())
  {
    return nearest;
  }
  QueryGrid grid(bounds, radius, queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    if (bounds.exteriorDistance(queries[i]) <= radius)
    {
      grid.insert(static_cast<Index>(i), queries[i], radius);
    }
  }
  // Points that differ by rounding alone are one place.
  const double same = 1e-12 * bounds.diagonal().norm();
  std::vector<double> distance(queries.size(), std::numeric_limits<double>::infinity());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const Indices* candidates = mesh.outgoing(v) == none ? nullptr : grid.near(mesh.point(v));
    if (!candidates)
    {
      continue;
    }
    for (Index i : *candidates)
    {
      const double d = (mesh.point(v) - queries[i]).norm();
      if (d > radius || d > distance[i] + same)
      {
        continue;
      }
      if (d < distance[i] - same)
      {
        nearest[i].clear();
      }
      nearest[i].push_back(v);
      distance[i] = std::min(d, distance[i]);
    }
  }
  return nearest;
}

Indices chooseVertices(const TriangleMesh& mesh, const std::vector<Indices>& candidates)
{
  // Dynamic programming along the curve: per candidate the fewest steps that are no edge.
  std::vector<Indices> jumps(candidates.size());
  std::vector<Indices> before(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    jumps[i].assign(candidates[i].size(), 0);
    before[i].assign(candidates[i].size(), none);
    for (std::size_t k = 0; i > 0 && k < candidates[i].size(); ++k)
    {
      for (std::size_t j = 0; j < candidates[i - 1].size(); ++j)
      {
        const Index from = candidates[i - 1][j];
        const Index to = candidates[i][k];
        const bool joined =
          from == to || mesh.find(from, to) != none || mesh.find(to, from) != none;
        const Index count = jumps[i - 1][j] + (joined ? 0 : 1);
        if (before[i][k] == none || count < jumps[i][k])
        {
          jumps[i][k] = count;
          before[i][k] = static_cast<Index>(j);
        }
      }
    }
  }
  Indices chosen(candidates.size(), none);
  Index next = none;
  for (std::size_t i = candidates.size(); i-- > 0;)
  {
    if (candidates[i].empty())
    {
      next = none;
      continue;
    }
    const Index k = next != none
      ? next
      : static_cast<Index>(std::min_element(jumps[i].begin(), jumps[i].end()) - jumps[i].begin());
    chosen[i] = candidates[i][k];
    next = before[i][k];
  }
  return chosen;
}
}
