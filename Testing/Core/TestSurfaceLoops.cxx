// SPDX-License-Identifier: BSD-3-Clause
// Plane sections, girths, loops drawn tight, and splines.
#include "ClosedMeshes.h"
#include "PathFacts.h"
#include "Paths/PathPoints.h"
#include "Paths/PlaneSection.h"
#include "Paths/StraightPath.h"
#include "Paths/SurfaceSpline.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Rings of a regular polygon above each other, with the radius and turn of each height; open at
/// both ends, or closed by a point.
TriangleMesh tube(Index sides, Index rings, const std::function<double(double)>& radius,
  double twist = 0.0, bool capped = false)
{
  const TriangleMesh open = rolledUp(sides, rings, [&](double turn, double height) -> Point3 {
    const double r = radius(height);
    const double angle = turn + twist * rings * height;
    return { r * std::cos(angle), r * std::sin(angle), 4.0 * height };
  });
  Points3 points = open.points();
  Triangles triangles = open.triangles();
  for (Index i = 0; capped && i < sides; ++i)
  {
    triangles.push_back({ rings * sides + i, rings * sides + (i + 1) % sides, open.vertexCount() });
  }
  points.resize(points.size() + (capped ? 1 : 0), Point3(0.0, 0.0, 4.5));
  return { std::move(points), std::move(triangles) };
}

double perimeter(Index sides, double radius)
{
  return 2.0 * sides * radius * std::sin(pi / sides);
}

/// A vertex of a closed path has at least pi on both sides at its first point as well.
double worstBendOfLoop(const TriangleMesh& mesh, const SurfacePath& loop)
{
  SurfacePath longer = loop;
  append(longer, loop);
  return worstBend(mesh, longer);
}
}

TEST(PlaneSection, AllCurvesOfASectionAreFoundOnceAlsoWhereItGoesThroughVertices)
{
  // The plane y = 0 goes through vertices of both walls of the tube; that above the middle closes.
  const TriangleMesh mesh = tube(12, 6, [](double) { return 1.0; });
  const std::vector<PlaneSection> along =
    planeSections(mesh, Point3::Zero(), Point3(0.0, 1.0, 0.0));
  ASSERT_EQ(along.size(), 2u);
  for (const PlaneSection& section : along)
  {
    EXPECT_FALSE(section.closed);
    EXPECT_NEAR(section.length, 4.0, 1e-12);
  }
  const std::vector<PlaneSection> across =
    planeSections(mesh, Point3(0.0, 0.0, 1.7), Point3(0.0, 0.0, 2.0));
  ASSERT_EQ(across.size(), 1u);
  EXPECT_TRUE(across[0].closed);
  EXPECT_NEAR(across[0].length, perimeter(12, 1.0), 1e-12);
  EXPECT_TRUE(planeSections(mesh, Point3(0.0, 0.0, 9.0), Point3(0.0, 0.0, 1.0)).empty());
  const std::vector<PlaneSection> round =
    planeSections(sphere(0), Point3::Zero(), Point3(0.0, 1.0, 0.0));
  ASSERT_EQ(round.size(), 1u);
  EXPECT_TRUE(round[0].closed);
  EXPECT_NEAR(round[0].length, 4.0 * std::sqrt(2.0), 1e-12);
}

TEST(PlaneSection, IsRefusedWhereThePlaneOnlyTouches)
{
  const TriangleMesh mesh = tube(
    12, 6, [](double) { return 1.0; }, 0.0, true);
  EXPECT_EQ(
    planeSection(mesh, vertexPoint(mesh, mesh.vertexCount() - 1), Point3::UnitZ()).status.code,
    StatusCode::CurveLeavesSurface);
  EXPECT_EQ(planeSection(mesh, vertexPoint(mesh, 0), Point3::Zero()).status.code,
    StatusCode::InvalidOption);
}

TEST(Girth, ThroughTwoPointsIsTheShortest)
{
  // Opposite points of one height: the tape lies level.
  const TriangleMesh mesh = tube(24, 20, [](double) { return 1.0; });
  const SurfacePoint start = vertexPoint(mesh, 8 * 24);
  const PlaneSection two = girth(mesh, { start, vertexPoint(mesh, 8 * 24 + 12) });
  ASSERT_TRUE(two.status.ok()) << two.status.message;
  EXPECT_NEAR(two.length, perimeter(24, 1.0), 1e-9);
  EXPECT_EQ(girth(mesh, { start }).status.code, StatusCode::InvalidOption);
}

TEST(StraightLoop, IsACircleRoundACylinder)
{
  for (const double twist : { 0.0, 0.05 })
  {
    const Index sides = 20;
    const TriangleMesh mesh = tube(
      sides, 20, [](double) { return 1.0; }, twist);
    const PathGraph graph(mesh);
    const PlaneSection start = planeSection(mesh,
      edgePoint(mesh, edgeOf(mesh, mesh.find(10 * sides, 11 * sides)), 0.3), Point3(0.5, 0.2, 1.0));
    ASSERT_TRUE(start.closed);
    const StraightPath loop = straightLoop(graph, start.path);
    ASSERT_TRUE(loop.status.ok()) << loop.status.message;
    EXPECT_LT(loop.length, start.length);
    EXPECT_LE(worstBendOfLoop(mesh, loop.path), 1e-9);
    if (twist == 0.0)
    {
      EXPECT_NEAR(loop.length, perimeter(sides, 1.0), 1e-9);
    }
  }
}

TEST(StraightLoop, ThatCanSlipOffIsRefused)
{
  const TriangleMesh mesh = tube(
    16, 10, [](double) { return 1.0; }, 0.0, true);
  const PathGraph graph(mesh);
  // Round a vertex of the wall.
  SurfacePath loop;
  const Index center = 5 * 16 + 3;
  for (const Index h : VertexFan(mesh, center))
  {
    loop.points.push_back(vertexPoint(mesh, mesh.to(h)));
    loop.triangles.push_back(h / 3);
  }
  loop.points.push_back(loop.points.front());
  ASSERT_TRUE(liesOn(mesh, loop));
  EXPECT_EQ(straightLoop(graph, loop).status.code, StatusCode::CurveTooShort);
  loop.points.pop_back();
  loop.triangles.pop_back();
  EXPECT_EQ(straightLoop(graph, loop).status.code, StatusCode::InvalidCurve);
}

TEST(StraightLoop, IsTheSameWithoutTheWaysThatItGoesThereAndBack)
{
  const Index sides = 14;
  const Index rings = 20;
  const TriangleMesh mesh = tube(
    sides, rings, [](double h) { return 1.0 + (h - 0.45) * (h - 0.45); }, 0.03);
  const PathGraph graph(mesh);
  std::mt19937 random(3);
  const auto any = [&random](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  double plain = 0.0;
  for (int k = 0; k < 200; ++k)
  {
    // A ring of edges, from whose vertices ways along edges go off and come back; none at first.
    const Index ring = 3 + k % (rings - 6);
    Indices walk;
    for (Index i = 0; i <= sides; ++i)
    {
      Indices there{ ring * sides + i % sides };
      for (std::size_t left = k == 0 || i == sides ? 0 : any(6); left > 0; --left)
      {
        Indices around;
        for (const Index h : VertexFan(mesh, there.back()))
        {
          around.push_back(mesh.to(h));
        }
        there.push_back(around[any(around.size())]);
      }
      walk.insert(walk.end(), there.begin(), there.end());
      walk.insert(walk.end(), there.rbegin() + 1, there.rend());
    }
    SurfacePath loop;
    for (std::size_t i = 0; i < walk.size(); ++i)
    {
      loop.points.push_back(vertexPoint(mesh, walk[i]));
      if (i > 0)
      {
        const Index h = mesh.find(walk[i - 1], walk[i]);
        loop.triangles.push_back((h != none ? h : mesh.find(walk[i], walk[i - 1])) / 3);
      }
    }
    const StraightPath tight = straightLoop(graph, loop);
    ASSERT_TRUE(tight.status.ok()) << k << ": " << tight.status.message;
    plain = k == 0 ? tight.length : plain;
    EXPECT_NEAR(tight.length, plain, 1e-9 * plain) << k;
    EXPECT_LE(worstBendOfLoop(mesh, tight.path), 1e-9) << k;
  }
}

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
