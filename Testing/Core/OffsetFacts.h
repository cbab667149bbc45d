// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PathFacts.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

/// Curves through points, and where their offsets must lie once the surface is unrolled.
namespace testmeshes
{
inline SurfacePoint nearest(const TriangleMesh& mesh, const Point3& point)
{
  const ClosestPoint closest = SurfaceLocator(mesh).closest(point);
  return snapToMesh(mesh, SnapDistance(mesh, 1e-9), closest);
}

inline SurfacePath through(const PathGraph& graph, const std::vector<SurfacePoint>& points)
{
  SurfacePath path;
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    const StraightPath leg = straightPath(graph, points[k - 1], points[k]);
    EXPECT_TRUE(leg.status.ok());
    if (k == 1)
    {
      path = leg.path;
    }
    else
    {
      append(path, leg.path);
    }
  }
  return path;
}

inline SurfacePath through(const PathGraph& graph, const Points3& points)
{
  std::vector<SurfacePoint> nodes;
  for (const Point3& point : points)
  {
    nodes.push_back(nearest(graph.mesh(), point));
  }
  return through(graph, nodes);
}

inline Surface square(Index count, double size)
{
  const auto flat = [=](double i, double j) { return Point2(size * i / count, size * j / count); };
  return patch(
    count, count, [&](double i, double j) { return Point3(flat(i, j).x(), flat(i, j).y(), 0.0); },
    flat);
}

/// Of a point of the plane from a polygon: the nearest foot, and whether it is within an edge.
struct Foot
{
  double distance = std::numeric_limits<double>::infinity();
  bool within = false;
  bool left = false;
};

inline Foot footOn(const Points2& line, const Point2& point)
{
  Foot foot;
  for (std::size_t k = 1; k < line.size(); ++k)
  {
    const Point2 side = line[k] - line[k - 1];
    const double s = side.dot(point - line[k - 1]) / side.squaredNorm();
    const Point2 way = point - line[k - 1] - std::clamp(s, 0.0, 1.0) * side;
    if (way.norm() < foot.distance * (1.0 - 1e-12))
    {
      foot = { way.norm(), s > 1e-6 && s<1.0 - 1e-6, side.x() * way.y() - side.y() * way.x()> 0 };
    }
  }
  return foot;
}

inline Points2 unrolled(const Surface& surface, const SurfacePath& path)
{
  Points2 line;
  for (const SurfacePoint& point : path.points)
  {
    line.push_back(testmeshes::unrolled(surface.mesh, surface.unrolled, point));
  }
  return line;
}
}
