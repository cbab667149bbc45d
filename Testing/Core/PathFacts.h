// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PathPoints.h"
#include "Surface/SurfaceTrace.h"
#include "Surface/VertexFan.h"
#include "TestMeshes.h"

#include <set>

/// What can be said of paths over surfaces without knowing how they were found.
namespace testmeshes
{
using namespace flattening;

inline double angleAt(const Point3& apex, const Point3& a, const Point3& b)
{
  return angleBetween(a - apex, b - apex);
}

/// The smaller of the angles on both sides of an interior point of a path, over the surface.
inline double sharperAngle(const TriangleMesh& mesh, const SurfacePath& path, std::size_t i)
{
  const SurfacePoint& point = path.points[i];
  const Point3& x = point.position;
  const Point3& before = path.points[i - 1].position;
  const Point3& after = path.points[i + 1].position;
  if (point.type == SurfacePointType::Edge)
  {
    const Point3& from = mesh.point(mesh.from(point.id));
    const Point3& to = mesh.point(mesh.to(point.id));
    const double one = angleAt(x, before, from) + angleAt(x, after, from);
    const double other = angleAt(x, before, to) + angleAt(x, after, to);
    return path.triangles[i - 1] == path.triangles[i] ? 0.0 : std::min(one, other);
  }
  if (point.type == SurfacePointType::Face)
  {
    return angleAt(x, before, after);
  }
  double total = 0.0;
  double in = 0.0;
  double out = 0.0;
  for (const Index h : VertexFan(mesh, point.id))
  {
    const Point3& first = mesh.point(mesh.to(h));
    if (h / 3 == path.triangles[i - 1])
    {
      in = total + angleAt(x, first, before);
    }
    if (h / 3 == path.triangles[i])
    {
      out = total + angleAt(x, first, after);
    }
    total += angleAt(x, first, mesh.point(mesh.from(TriangleMesh::previous(h))));
  }
  const double within = std::abs(out - in);
  return mesh.onBoundary(point.id) ? within : std::min(within, total - within);
}

/// How much less than pi the angles of a path are, beyond what rounding of its points can do.
inline double worstBend(const TriangleMesh& mesh, const SurfacePath& path)
{
  double size = 0.0;
  for (const Point3& point : mesh.points())
  {
    size = std::max(size, point.cwiseAbs().maxCoeff());
  }
  double worst = 0.0;
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i)
  {
    const double step = std::min((path.points[i].position - path.points[i - 1].position).norm(),
      (path.points[i + 1].position - path.points[i].position).norm());
    worst = std::max(worst, pi - sharperAngle(mesh, path, i) - 1e-15 * size / step);
  }
  return worst;
}

/// A vertex, a point of an edge or one of a triangle.
inline SurfacePoint randomPoint(const TriangleMesh& mesh, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto t = static_cast<Index>(random() % mesh.triangleCount());
  const auto corner = static_cast<Index>(random() % 3);
  switch (random() % 3)
  {
    case 0:
      return vertexPoint(mesh, mesh.triangle(t)[corner]);
    case 1:
      return edgePoint(mesh, edgeOf(mesh, 3 * t + corner), 0.01 + 0.98 * unit(random));
    default:
      break;
  }
  std::array<double, 3> weights{ unit(random), unit(random), unit(random) };
  const double sum = weights[0] + weights[1] + weights[2];
  Point3 position = Point3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    weights[k] /= sum;
    position += weights[k] * mesh.point(mesh.triangle(t)[k]);
  }
  return { SurfacePointType::Face, t, weights, position };
}

inline SurfacePoint nearestPoint(const TriangleMesh& mesh, const Point3& point)
{
  const ClosestPoint closest = SurfaceLocator(mesh).closest(point);
  return snapToMesh(mesh, SnapDistance(mesh, 1e-9), closest);
}

/// Where a point lies in an unrolling of the surface.
inline Point2 unrolled(const TriangleMesh& mesh, const Points2& flat, const SurfacePoint& point)
{
  switch (point.type)
  {
    case SurfacePointType::Vertex:
      return flat[point.id];
    case SurfacePointType::Edge:
      return point.weights[0] * flat[mesh.from(point.id)] +
        point.weights[1] * flat[mesh.to(point.id)];
    case SurfacePointType::Face:
      break;
  }
  const Triangle& corner = mesh.triangle(point.id);
  return point.weights[0] * flat[corner[0]] + point.weights[1] * flat[corner[1]] +
    point.weights[2] * flat[corner[2]];
}

/// The shortest way from point to point by edges, and within the triangles of both.
inline double lengthByEdges(
  const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to)
{
  std::vector<double> distance(mesh.vertexCount(), std::numeric_limits<double>::infinity());
  std::set<std::pair<double, Index>> queue;
  const auto reach = [&](Index v, double length) {
    if (length < distance[v])
    {
      distance[v] = length;
      queue.insert({ length, v });
    }
  };
  for (const Index t : trianglesAround(mesh, from))
  {
    for (const Index v : mesh.triangle(t))
    {
      reach(v, (mesh.point(v) - from.position).norm());
    }
  }
  while (!queue.empty())
  {
    const auto [length, v] = *queue.begin();
    queue.erase(queue.begin());
    for (const Index h : VertexFan(mesh, v))
    {
      reach(mesh.to(h), length + mesh.length(h));
      reach(mesh.from(TriangleMesh::previous(h)), length + mesh.length(TriangleMesh::previous(h)));
    }
  }
  double shortest = std::numeric_limits<double>::infinity();
  for (const Index t : trianglesAround(mesh, to))
  {
    for (const Index v : mesh.triangle(t))
    {
      shortest = std::min(shortest, distance[v] + (mesh.point(v) - to.position).norm());
    }
  }
  return shortest;
}
}
