// SPDX-License-Identifier: BSD-3-Clause
// Plane sections, girths and loops drawn tight.
#include "ClosedMeshes.h"
#include "PathFacts.h"
#include "Paths/PathPoints.h"
#include "Paths/PlaneSection.h"
#include "Paths/StraightPath.h"

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
