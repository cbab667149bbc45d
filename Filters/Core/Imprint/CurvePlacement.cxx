// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/CurvePlacement.h"

#include "Imprint/VertexMatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
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

WaysOut CurvePlacement::waysFrom(double farthest) const
{
  const double fraction = roundedUp(farthest / this->Diagonal);
  WaysOut ways{ Remedy::ProjectPoints };
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
