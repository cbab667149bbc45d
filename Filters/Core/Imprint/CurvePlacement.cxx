// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/CurvePlacement.h"

#include "Surface/TriangleMesh.h"

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

/// Per query the nearest vertex within the radius, with all others at the same place; ascending
/// ids.
///
/// One pass over the vertices against a hashed grid of the queries: a few curves on a large mesh
/// cost no search structure over the mesh. Vertices that no triangle uses are left out.
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

/// One vertex per point of a polyline, none where it has no candidate. Where points of the mesh
/// coincide without being joined, as on the two sides of an open slit, the curve stays on its side:
/// as many steps as possible are edges; then the smaller ids win.
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

/// Of the surface's diagonal: a curve that is farther off was not drawn on this surface as it is.
constexpr double nearby = 0.1;

double diagonal(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d bounds;
  for (const Triangle& t : mesh.triangles())
  {
    for (Index v : t)
    {
      bounds.extend(mesh.point(v));
    }
  }
  return bounds.isEmpty() ? 0.0 : bounds.diagonal().norm();
}

/// The next larger number of two digits.
double roundedUp(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::ceil(value / unit * (1.0 - 1e-12)) * unit;
}
}

CurvePlacement::CurvePlacement(
  const TriangleMesh& mesh, const std::vector<Polyline>& polylines, const ImprintOptions& options)
  : Mesh(mesh)
  , Polylines(polylines)
  , Options(options)
  , Diagonal(diagonal(mesh))
  , Reach(options.tolerance * this->Diagonal)
  , AtVertex(mesh, std::max(0.01, options.snap))
{
}

void CurvePlacement::findVertices()
{
  Points3 queries;
  for (const Polyline& polyline : this->Polylines)
  {
    this->First.push_back(queries.size());
    queries.insert(queries.end(), polyline.points.begin(), polyline.points.end());
  }
  const double reach =
    this->Options.split ? std::min(this->Reach, this->AtVertex.greatest()) : this->Reach;
  std::vector<Indices> candidates = matchVertices(this->Mesh, queries, reach);
  this->keepNearVertices(queries, candidates);
  for (std::size_t c = 0; c < this->Polylines.size(); ++c)
  {
    const auto first = candidates.begin() + static_cast<std::ptrdiff_t>(this->First[c]);
    const Indices chosen = chooseVertices(
      this->Mesh, { first, first + static_cast<std::ptrdiff_t>(this->Polylines[c].points.size()) });
    this->Vertices.insert(this->Vertices.end(), chosen.begin(), chosen.end());
  }
}

/// The tolerance says how far from the surface a point may be. It must not drag points along the
/// surface to vertices that are not meant: where triangles can be split, those that are not near;
/// else those that are not the nearest.
void CurvePlacement::keepNearVertices(
  const Points3& queries, std::vector<Indices>& candidates) const
{
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    Indices& near = candidates[i];
    const auto distance = [&](Index vertex) {
      return (this->Mesh.point(vertex) - queries[i]).norm();
    };
    double nearest = std::numeric_limits<double>::infinity();
    for (const Index vertex : near)
    {
      nearest = std::min(nearest, distance(vertex));
    }
    near.erase(std::remove_if(near.begin(), near.end(),
                 [&](Index vertex) {
                   return distance(vertex) > this->AtVertex.ofVertex(vertex) &&
                     (this->Options.split || distance(vertex) > nearest);
                 }),
      near.end());
  }
}

SuggestedRemedies CurvePlacement::waysFrom(double farthest) const
{
  const double fraction = roundedUp(farthest / this->Diagonal);
  SuggestedRemedies ways{ Remedy::ProjectPoints };
  if (fraction <= nearby)
  {
    ways.push_back({ Remedy::RaiseImprintTolerance, shortNumber(fraction) });
  }
  return ways;
}

Status CurvePlacement::locate(std::size_t c, std::vector<ClosestPoint>& closest)
{
  if (!this->Locator)
  {
    this->Locator.emplace(this->Mesh);
  }
  const Polyline& polyline = this->Polylines[c];
  Indices off;
  double farthest = 0.0;
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
  {
    closest.push_back(this->Locator->closest(polyline.points[i]));
    if (closest.back().triangle == none || closest.back().distance > this->Reach)
    {
      off.push_back(pointId(polyline, i));
      farthest = std::max(farthest, closest.back().distance);
    }
  }
  if (off.empty())
  {
    return {};
  }
  return { StatusCode::CurvePointOffSurface,
    curveName(polyline, c) + ": points " + listIds(off) + " lie up to " + shortNumber(farthest) +
      " off the surface, more than the tolerance of " + shortNumber(this->Reach) +
      (farthest > nearby * this->Diagonal
          ? ", as where curve and surface differ in unit, axes or place"
          : ""),
    { ElementKind::CurvePoints, off }, this->waysFrom(farthest) };
}
}
