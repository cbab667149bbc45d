// SPDX-License-Identifier: BSD-3-Clause
#include "CurveImprint.h"

#include "VertexMatch.h"

#include <cmath>

namespace flattening
{
namespace
{
std::string curveName(const Polyline& polyline, std::size_t id)
{
  return polyline.name.empty() ? "curve " + std::to_string(id) : "curve \"" + polyline.name + "\"";
}

Index pointId(const Polyline& polyline, std::size_t i)
{
  return i < polyline.pointIds.size() ? polyline.pointIds[i] : static_cast<Index>(i);
}

ImprintedSurface refuse(StatusCode code, std::string message, Indices ids)
{
  ImprintedSurface result;
  result.status = { code, std::move(message), std::move(ids) };
  return result;
}

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

Status checkPolyline(const Polyline& polyline, std::size_t id)
{
  Indices bad;
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
  {
    if (!polyline.points[i].allFinite())
    {
      bad.push_back(pointId(polyline, i));
    }
  }
  if (!bad.empty())
  {
    return { StatusCode::NonFinitePoint,
      curveName(polyline, id) + ": points " + listIds(bad) +
        " have a coordinate that is not a finite number; mend or remove them",
      bad };
  }
  if (polyline.keyShape == KeyShape::Planar &&
    polyline.planarShape.size() != polyline.points.size())
  {
    return { StatusCode::InvalidCurve,
      curveName(polyline, id) + " has " + std::to_string(polyline.points.size()) +
        " points, its planar shape " + std::to_string(polyline.planarShape.size()) +
        "; give one planar point for each point",
      { static_cast<Index>(id) } };
  }
  return {};
}

/// Identity: the mesh as it is.
ImprintedSurface keepMesh(const TriangleMesh& mesh)
{
  ImprintedSurface result;
  result.mesh = mesh;
  result.vertexSource.resize(mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    result.vertexSource[v].vertices = { v, v, v };
  }
  result.originalTriangle.resize(mesh.triangleCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    result.originalTriangle[t] = t;
  }
  return result;
}

FeatureCurve startCurve(const Polyline& polyline)
{
  FeatureCurve curve;
  curve.name = polyline.name;
  curve.type = polyline.type;
  curve.keyShape = polyline.keyShape;
  curve.tolerance = polyline.tolerance;
  return curve;
}
}

ImprintedSurface imprintCurves(
  const TriangleMesh& mesh, const std::vector<Polyline>& polylines, const ImprintOptions& options)
{
  Points3 queries;
  for (std::size_t c = 0; c < polylines.size(); ++c)
  {
    Status status = checkPolyline(polylines[c], c);
    if (!status.ok())
    {
      return refuse(status.code, std::move(status.message), std::move(status.ids));
    }
    queries.insert(queries.end(), polylines[c].points.begin(), polylines[c].points.end());
  }
  const Indices nearest = matchVertices(mesh, queries, options.tolerance * diagonal(mesh));

  ImprintedSurface result = keepMesh(mesh);
  std::size_t first = 0;
  for (std::size_t c = 0; c < polylines.size(); ++c)
  {
    const Polyline& polyline = polylines[c];
    FeatureCurve curve = startCurve(polyline);
    Indices off;
    Indices notEdges;
    std::size_t previous = 0;
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      const Index vertex = nearest[first + i];
      if (vertex == none)
      {
        off.push_back(pointId(polyline, i));
        continue;
      }
      if (!curve.vertices.empty())
      {
        const Index last = curve.vertices.back();
        if (last == vertex)
        {
          continue;
        }
        if (mesh.find(last, vertex) == none && mesh.find(vertex, last) == none)
        {
          notEdges.push_back(pointId(polyline, previous));
          notEdges.push_back(pointId(polyline, i));
        }
      }
      previous = i;
      curve.vertices.push_back(vertex);
      if (polyline.keyShape == KeyShape::Planar)
      {
        curve.planarShape.push_back(polyline.planarShape[i]);
      }
    }
    if (!off.empty())
    {
      return refuse(StatusCode::CurvePointOffSurface,
        curveName(polyline, c) + ": points " + listIds(off) +
          " lie on no vertex of the surface; project them onto it, or raise the tolerance",
        off);
    }
    if (!notEdges.empty())
    {
      return refuse(StatusCode::CurveNotOnEdges,
        curveName(polyline, c) + ": between points " + std::to_string(notEdges[0]) + " and " +
          std::to_string(notEdges[1]) +
          " the curve is no edge of the mesh; allow triangles to be split, or draw it along edges",
        notEdges);
    }
    if (curve.vertices.size() < 2)
    {
      return refuse(StatusCode::CurveTooShort,
        curveName(polyline, c) + " has fewer than two different points; remove it or draw it again",
        { static_cast<Index>(c) });
    }
    result.curves.push_back(std::move(curve));
    first += polyline.points.size();
  }
  return result;
}
}
