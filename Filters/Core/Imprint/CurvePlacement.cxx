// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/CurvePlacement.h"

#include "Imprint/VertexMatch.h"

#include <algorithm>

namespace flattening
{
namespace
{
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
}

CurvePlacement::CurvePlacement(
  const TriangleMesh& mesh, const std::vector<Polyline>& polylines, const ImprintOptions& options)
  : Mesh(mesh)
  , Polylines(polylines)
  , Options(options)
  , Reach(options.tolerance * diagonal(mesh))
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
  std::vector<Indices> candidates = matchVertices(this->Mesh, queries, this->Reach);
  this->keepNearVertices(queries, candidates);
  for (std::size_t c = 0; c < this->Polylines.size(); ++c)
  {
    const auto first = candidates.begin() + static_cast<std::ptrdiff_t>(this->First[c]);
    const Indices chosen = chooseVertices(
      this->Mesh, { first, first + static_cast<std::ptrdiff_t>(this->Polylines[c].points.size()) });
    this->Vertices.insert(this->Vertices.end(), chosen.begin(), chosen.end());
  }
}

/// The tolerance says how far from the surface a point may be. Where triangles can be split, it
/// must not drag points along the surface to vertices that are not meant.
void CurvePlacement::keepNearVertices(
  const Points3& queries, std::vector<Indices>& candidates) const
{
  for (std::size_t i = 0; i < queries.size() && this->Options.split; ++i)
  {
    Indices& near = candidates[i];
    near.erase(std::remove_if(near.begin(), near.end(),
                 [&](Index vertex) {
                   return (this->Mesh.point(vertex) - queries[i]).norm() >
                     this->AtVertex.ofVertex(vertex);
                 }),
      near.end());
  }
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
      " off the surface, more than the tolerance of " + shortNumber(this->Reach),
    { ElementKind::CurvePoints, off }, { Remedy::ProjectPoints, Remedy::RaiseImprintTolerance } };
}
}
