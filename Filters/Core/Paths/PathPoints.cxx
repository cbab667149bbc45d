// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathPoints.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// A corner of less weight counts for nothing: whether a point lies on an edge is not left to
/// rounding.
constexpr double minWeight = 1e-12;
}

std::array<double, 3> weightsIn(const TriangleMesh& mesh, Index triangle, const SurfacePoint& point)
{
  if (point.type == SurfacePointType::Face)
  {
    return point.weights;
  }
  std::array<double, 3> weights{ 0.0, 0.0, 0.0 };
  const bool vertex = point.type == SurfacePointType::Vertex;
  for (Index k = 0; k < 3; ++k)
  {
    const Index corner = mesh.triangle(triangle)[k];
    if (corner == (vertex ? point.id : mesh.from(point.id)))
    {
      weights[k] = point.weights[0];
    }
    else if (!vertex && corner == mesh.to(point.id))
    {
      weights[k] = point.weights[1];
    }
  }
  return weights;
}

bool liesOn(const TriangleMesh& mesh, const SurfacePoint& point)
{
  switch (point.type)
  {
    case SurfacePointType::Vertex:
      return point.id >= 0 && point.id < mesh.vertexCount() && mesh.outgoing(point.id) != none;
    case SurfacePointType::Edge:
      return point.id >= 0 && point.id < mesh.halfedgeCount() && edgeOf(mesh, point.id) == point.id;
    case SurfacePointType::Face:
      break;
  }
  return point.id >= 0 && point.id < mesh.triangleCount();
}

bool liesOn(const TriangleMesh& mesh, const SurfacePath& path)
{
  if (path.points.empty() || path.points.size() != path.triangles.size() + 1 ||
    !std::all_of(path.points.begin(), path.points.end(),
      [&mesh](const SurfacePoint& point) { return liesOn(mesh, point); }))
  {
    return false;
  }
  for (std::size_t i = 0; i < path.triangles.size(); ++i)
  {
    const Index t = path.triangles[i];
    if (t < 0 || t >= mesh.triangleCount() || !contains(mesh, t, path.points[i]) ||
      !contains(mesh, t, path.points[i + 1]))
    {
      return false;
    }
  }
  return true;
}

Status checkPoints(
  const TriangleMesh& mesh, const std::vector<SurfacePoint>& points, const std::string& what)
{
  if (mesh.triangleCount() == 0)
  {
    return { StatusCode::EmptySurface, "there is no triangle to draw on", {},
      { Remedy::GiveTriangles } };
  }
  for (const SurfacePoint& point : points)
  {
    if (!liesOn(mesh, point))
    {
      return { StatusCode::InvalidPointId,
        what + " in " + std::to_string(point.id) +
          ", which is not a vertex, edge or triangle of the surface" };
    }
  }
  return {};
}

SurfacePoint pointOf(const TriangleMesh& mesh, Index triangle, const std::array<double, 3>& weights)
{
  Point3 position = Point3::Zero();
  Indices corners;
  for (Index k = 0; k < 3; ++k)
  {
    position += weights[k] * mesh.point(mesh.triangle(triangle)[k]);
    if (weights[k] > minWeight)
    {
      corners.push_back(k);
    }
  }
  if (corners.size() == 1)
  {
    return vertexPoint(mesh, mesh.triangle(triangle)[corners[0]]);
  }
  if (corners.size() == 2)
  {
    const Index h = 3 * triangle + ((corners[0] + 1) % 3 == corners[1] ? corners[0] : corners[1]);
    return edgePoint(mesh, h, weights[(h + 1) % 3]);
  }
  return { SurfacePointType::Face, triangle, weights, position };
}

SurfacePoint pointBetween(
  const TriangleMesh& mesh, Index triangle, const SurfacePoint& a, const SurfacePoint& b, double s)
{
  if (s <= 0.0 || s >= 1.0)
  {
    return s <= 0.0 ? a : b;
  }
  const std::array<double, 3> atA = weightsIn(mesh, triangle, a);
  const std::array<double, 3> atB = weightsIn(mesh, triangle, b);
  std::array<double, 3> weights;
  for (Index k = 0; k < 3; ++k)
  {
    weights[k] = (1.0 - s) * atA[k] + s * atB[k];
  }
  return pointOf(mesh, triangle, weights);
}

SurfacePoint pointAlong(const TriangleMesh& mesh, const SurfacePath& path, double distance)
{
  double done = 0.0;
  for (std::size_t i = 0; i < path.triangles.size(); ++i)
  {
    const SurfacePoint& a = path.points[i];
    const SurfacePoint& b = path.points[i + 1];
    const double step = (b.position - a.position).norm();
    if (done + step >= distance && step > 0.0)
    {
      return pointBetween(mesh, path.triangles[i], a, b, (distance - done) / step);
    }
    done += step;
  }
  return path.points.back();
}

SurfacePath partOf(const SurfacePath& path, std::size_t first, std::size_t last)
{
  const auto at = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
  SurfacePath part;
  part.points.assign(path.points.begin() + at(first), path.points.begin() + at(last + 1));
  part.triangles.assign(path.triangles.begin() + at(first), path.triangles.begin() + at(last));
  part.arrived = true;
  return part;
}

SurfacePath reversed(SurfacePath path)
{
  std::reverse(path.points.begin(), path.points.end());
  std::reverse(path.triangles.begin(), path.triangles.end());
  return path;
}

void append(SurfacePath& path, const SurfacePath& more)
{
  path.points.insert(path.points.end(), more.points.begin() + 1, more.points.end());
  path.triangles.insert(path.triangles.end(), more.triangles.begin(), more.triangles.end());
  path.arrived = more.arrived;
  path.atBoundary = more.atBoundary;
}
}
