// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/ImprintedSurface.h"

#include "Surface/SurfacePreparation.h"

#include <cmath>

namespace flattening
{
namespace
{
Status checkPolyline(const Polyline& polyline, std::size_t id)
{
  Indices bad;
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
  {
    if (!isUsable(polyline.points[i]))
    {
      bad.push_back(pointId(polyline, i));
    }
  }
  if (!bad.empty())
  {
    return { StatusCode::NonFinitePoint,
      curveName(polyline, id) + ": points " + listIds(bad) +
        " have a coordinate that is not a finite number, or beyond 1e60",
      { ElementKind::CurvePoints, bad }, { Remedy::MendPoints } };
  }
  if (polyline.keyShape == KeyShape::Planar &&
    polyline.planarShape.size() != polyline.points.size())
  {
    return { StatusCode::InvalidCurve,
      curveName(polyline, id) + " has " + std::to_string(polyline.points.size()) +
        " points, its planar shape " + std::to_string(polyline.planarShape.size()),
      { ElementKind::Curves, Indices{ static_cast<Index>(id) } },
      { { Remedy::Give, "one planar point for each point" } } };
  }
  return {};
}

/// Puts the stretches of a polyline together and gives each vertex its planar point. The mesh is
/// the one that the route's vertices are of. No vertices where the route has no start.
FeatureCurve assembleCurve(const TriangleMesh& mesh, const Polyline& polyline, const Route& route)
{
  FeatureCurve curve{ polyline.name, polyline.type, polyline.keyShape, polyline.tolerance,
    polyline.ease, {}, {} };
  if (route.start == none)
  {
    return curve;
  }
  curve.vertices.push_back(route.start);
  const bool planar = polyline.keyShape == KeyShape::Planar;
  if (planar)
  {
    curve.planarShape.push_back(polyline.planarShape[route.firstPoint]);
  }
  std::size_t before = route.firstPoint;
  for (std::size_t s = 0; s < route.stretches.size(); ++s)
  {
    const Indices& stretch = route.stretches[s];
    if (stretch.size() < 2)
    {
      continue;
    }
    double whole = 0.0;
    for (std::size_t i = 1; i < stretch.size(); ++i)
    {
      whole += (mesh.point(stretch[i]) - mesh.point(stretch[i - 1])).norm();
    }
    double done = 0.0;
    for (std::size_t i = 1; i < stretch.size(); ++i)
    {
      done += (mesh.point(stretch[i]) - mesh.point(stretch[i - 1])).norm();
      curve.vertices.push_back(stretch[i]);
      if (planar)
      {
        const double f = i + 1 == stretch.size() ? 1.0 : done / whole;
        curve.planarShape.push_back(
          (1.0 - f) * polyline.planarShape[before] + f * polyline.planarShape[route.points[s]]);
      }
    }
    before = route.points[s];
  }
  return curve;
}
}

Status assembleCurves(const TriangleMesh& mesh, const std::vector<Polyline>& polylines,
  const std::vector<Route>& routes, std::vector<FeatureCurve>& curves)
{
  for (std::size_t c = 0; c < routes.size(); ++c)
  {
    FeatureCurve curve = assembleCurve(mesh, polylines[c], routes[c]);
    if (curve.vertices.size() < 2)
    {
      return { StatusCode::CurveTooShort,
        curveName(polylines[c], c) + " has fewer than two different points",
        { ElementKind::Curves, Indices{ static_cast<Index>(c) } }, { Remedy::RedrawCurve },
        static_cast<Index>(c) };
    }
    curves.push_back(std::move(curve));
  }
  return {};
}

Status checkPolylines(const std::vector<Polyline>& polylines)
{
  for (std::size_t c = 0; c < polylines.size(); ++c)
  {
    Status status = checkPolyline(polylines[c], c);
    if (!status.ok())
    {
      status.curve = static_cast<Index>(c);
      return status;
    }
  }
  return {};
}

std::string curveName(const Polyline& polyline, std::size_t id)
{
  return polyline.name.empty() ? "curve " + std::to_string(id) : "curve \"" + polyline.name + "\"";
}

Index pointId(const Polyline& polyline, std::size_t point)
{
  return point < polyline.pointIds.size() ? polyline.pointIds[point] : static_cast<Index>(point);
}
}
