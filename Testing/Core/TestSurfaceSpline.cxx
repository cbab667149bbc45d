// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedMeshes.h"
#include "PathFacts.h"
#include "Paths/PathPoints.h"
#include "Paths/SurfaceSpline.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// The sharpest turn of the polygon of every n-th part of the curve's length.
double sharpestTurn(const TriangleMesh& mesh, const SurfaceSpline& spline, int parts)
{
  double sharpest = 0.0;
  Points3 points;
  for (int k = 0; k <= parts; ++k)
  {
    points.push_back(pointAlong(mesh, spline.path, spline.length * k / parts).position);
  }
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
  {
    sharpest = std::max(sharpest, pi - angleAt(points[k], points[k - 1], points[k + 1]));
  }
  return sharpest;
}
}

TEST(SurfaceSpline, ThroughPointsOfACircleIsNearlyOne)
{
  const Surface surface =
    patch(60, 60, [](double i, double j) { return Point3(i / 30.0 - 1.0, j / 30.0 - 1.0, 0.0); });
  const PathGraph graph(surface.mesh);
  const SurfaceLocator locator(surface.mesh);
  std::vector<SurfacePoint> points;
  for (int k = 0; k < 8; ++k)
  {
    points.push_back(nearestPoint(surface.mesh,
      Point3(0.7 * std::cos(pi * k / 4.0 + 0.1), 0.7 * std::sin(pi * k / 4.0 + 0.1), 0.0)));
  }
  const SurfaceSpline spline = surfaceSpline(graph, locator, points, true);
  ASSERT_TRUE(spline.status.ok());
  // The cubic polynomial through four of the points is that far from the circle half-way.
  const double off = 0.7 * (1.0 - (9.0 * std::cos(pi / 8.0) - std::cos(3.0 * pi / 8.0)) / 8.0);
  for (const SurfacePoint& point : spline.path.points)
  {
    EXPECT_NEAR(point.position.norm(), 0.7, 1.01 * off);
  }
}

TEST(SurfaceSpline, ThroughPointsOfALineIsTheLine)
{
  Surface surface = flatPatch(30, 30);
  const PathGraph graph(surface.mesh);
  const SurfaceLocator locator(surface.mesh);
  const SurfacePoint a = vertexPoint(surface.mesh, 5 * 31 + 4);
  const SurfacePoint b = vertexPoint(surface.mesh, 22 * 31 + 27);
  std::vector<SurfacePoint> points;
  for (const double s : { 0.0, 0.1, 0.5, 0.6, 1.0 }) // uneven steps
  {
    points.push_back(nearestPoint(surface.mesh, (1.0 - s) * a.position + s * b.position));
  }
  const SurfaceSpline spline = surfaceSpline(graph, locator, points, false);
  ASSERT_TRUE(spline.status.ok());
  EXPECT_NEAR(spline.length, (b.position - a.position).norm(), 1e-9);
}

TEST(SurfaceSpline, HasNoCorners)
{
  const Surface surface = cushion(60, 60, 0.25);
  const PathGraph graph(surface.mesh);
  const SurfaceLocator locator(surface.mesh);
  std::vector<SurfacePoint> points;
  for (const Point3& p :
    { Point3(0.1, 0.2, 0), Point3(0.4, 0.7, 0.2), Point3(0.6, 0.3, 0.2), Point3(0.9, 0.8, 0.1) })
  {
    points.push_back(nearestPoint(surface.mesh, p));
  }
  const SurfaceSpline corners = surfaceSpline(graph, locator, points, false, 0);
  const SurfaceSpline spline = surfaceSpline(graph, locator, points, false, 5);
  // A corner stays, however short the parts are; on a smooth curve short parts turn less.
  EXPECT_GT(sharpestTurn(surface.mesh, corners, 256), 1.0);
  EXPECT_LT(sharpestTurn(surface.mesh, spline, 256), 0.6 * sharpestTurn(surface.mesh, spline, 64));
}

TEST(SurfaceSpline, GoesThroughAllPointsOnSliversWherePathsAreNotStraight)
{
  int bent = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto share = [&random] { return (random() & 0xffffU) / 65536.0; };
    std::array<std::vector<double>, 2> lines;
    for (std::vector<double>& line : lines)
    {
      for (int k = 0; k < 15; ++k)
      {
        const double small = share();
        line.push_back(std::pow(10.0, -25.0 * small * share()));
      }
      std::sort(line.begin(), line.end()); // so that no step is lost in the sum of those before
      std::partial_sum(line.begin(), line.end(), line.begin());
    }
    const Surface surface = patch(14, 14, [&](double i, double j) {
      const double x = lines[0][static_cast<std::size_t>(i)];
      const double y = lines[1][static_cast<std::size_t>(j)];
      const double rough = 0.1 * std::pow(10.0, -25.0 * share());
      return Point3(x, y, 0.3 * std::sin(3.0 * x) * std::cos(2.0 * y) + rough);
    });
    std::vector<SurfacePoint> points;
    for (int k = 0; k < 5; ++k)
    {
      const auto triangle = static_cast<Index>(random() % surface.mesh.triangleCount());
      const double a = share();
      const double b = share() * (1.0 - a);
      points.push_back(pointOf(surface.mesh, triangle, { 1.0 - a - b, a, b }));
    }
    const PathGraph graph(surface.mesh);
    const SurfaceSpline spline =
      surfaceSpline(graph, SurfaceLocator(surface.mesh), points, seed % 2 == 0);
    if (spline.status.refused())
    {
      continue;
    }
    bent += spline.status.ok() ? 0 : 1;
    ASSERT_GE(spline.stations.size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      ASSERT_LT(spline.stations[k], spline.path.points.size());
      EXPECT_TRUE(samePlace(spline.path.points[spline.stations[k]], points[k])) << k;
    }
  }
  EXPECT_GT(bent, 0); // else nothing is shown
}

TEST(SurfaceSpline, ThroughCornersIsTheSameInEveryUnitWhereTwoFacesAreEquallyNear)
{
  // A spline leaves a prism in the plane that halves the angle of an edge.
  const auto prism = [](Index sides, Index rows) {
    const TriangleMesh wall = revolved(sides, rows, 0.7 * rows);
    Triangles triangles = wall.triangles();
    for (const Index end : { 0, rows * sides })
    {
      for (Index i = 1; i + 1 < sides; ++i)
      {
        triangles.push_back({ end, end + (end == 0 ? i + 1 : i), end + (end == 0 ? i : i + 1) });
      }
    }
    return TriangleMesh(wall.points(), std::move(triangles));
  };
  int left = 0;
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto sides = 3 + static_cast<Index>(random() % 6);
    const auto rows = 1 + static_cast<Index>(random() % 4);
    const TriangleMesh shape = prism(sides, rows);
    const Eigen::AngleAxisd turn(1.0 + seed, Point3(1.0, std::sin(seed), 0.5).normalized());
    Indices corners{ static_cast<Index>(random() % shape.vertexCount()) };
    while (corners.size() < 4)
    {
      const auto corner = static_cast<Index>(random() % shape.vertexCount());
      if (corner != corners.back())
      {
        corners.push_back(corner);
      }
    }
    std::vector<double> lengths;
    for (const double unit : { 1.0, 1e-3, 1e-2, 1e3 })
    {
      const TriangleMesh mesh =
        moved(shape, [&](const Point3& p) -> Point3 { return unit * (turn * p); });
      std::vector<SurfacePoint> points;
      for (const Index corner : corners)
      {
        points.push_back(vertexPoint(mesh, corner));
      }
      const SurfaceSpline spline =
        surfaceSpline(PathGraph(mesh), SurfaceLocator(mesh), points, false);
      ASSERT_TRUE(spline.status.ok()) << spline.status.message;
      lengths.push_back(spline.length / unit);
    }
    for (const double length : lengths)
    {
      EXPECT_NEAR(length, lengths.front(), 1e-9 * length);
    }
    left += lengths.front() > 4.0 ? 1 : 0;
  }
  EXPECT_GT(left, 100);
}
