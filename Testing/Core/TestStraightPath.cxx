// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveDrawing.h"
#include "PathFacts.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"
#include "Renumbered.h"

#include <memory>

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr double rounding = 1e-9;

/// A whole cone (a regular pyramid of many sides) with its apex, vertex 0.
TriangleMesh wholeCone(Index sides, Index rings)
{
  return disk(rings, sides, [](double r, double turn) {
    return Point3(0.5 * r * std::cos(turn), 0.5 * r * std::sin(turn), 1.0 - r);
  });
}

/// A flat square of 12 x 12 squares without the 6 x 6 at its upper right.
TriangleMesh flatAngle()
{
  return partWhere(unitSquares(12, 12).mesh, [](const Point3& p) {
    return p.x() < 6.0 || p.y() < 6.0;
  }).mesh;
}

Index vertexAt(const TriangleMesh& mesh, const Point3& point)
{
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if ((mesh.point(v) - point).norm() < 1e-12)
    {
      return v;
    }
  }
  return none;
}

void expectExact(const Surface& surface, double innerRadius)
{
  const TriangleMesh& mesh = surface.mesh;
  const PathGraph graph(mesh);
  std::mt19937 random(1);
  int tried = 0;
  while (tried < 200)
  {
    const SurfacePoint from = randomPoint(mesh, random);
    const SurfacePoint to = randomPoint(mesh, random);
    const Point2 a = unrolled(mesh, surface.unrolled, from);
    const Point2 b = unrolled(mesh, surface.unrolled, to);
    const double s = std::clamp(-a.dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    if (!((a + s * (b - a)).norm() >= innerRadius))
    {
      continue; // the straight line leaves the surface
    }
    ++tried;
    const StraightPath path = straightPath(graph, from, to);
    ASSERT_TRUE(path.status.ok()) << path.status.message;
    ASSERT_TRUE(liesOn(mesh, path.path));
    EXPECT_NEAR(path.length, (b - a).norm(), rounding * (b - a).norm());
    EXPECT_NEAR(path.length, lengthOf(path.path), 1e-12 * path.length);
    EXPECT_LE(worstBend(mesh, path.path), rounding);
  }
}
}

TEST(StraightPath, IsALineOnUnrolledCylinderAndCone)
{
  expectExact(cylinder(40, 30), 0.0);
  // The unrolled inner edge is a chain of chords of the circle with radius 0.4.
  expectExact(cone(40, 30), 0.4);
}

TEST(StraightPath, TakesTheShorterWayRoundTheApexOfACone)
{
  const Index sides = 24;
  const Index rings = 15;
  const TriangleMesh mesh = wholeCone(sides, rings);
  const PathGraph graph(mesh);
  const double slant = (mesh.point(mesh.vertexCount() - 1) - mesh.point(0)).norm();
  const double step = angleBetween(mesh.point(1) - mesh.point(0), mesh.point(2) - mesh.point(0));
  std::mt19937 random(1);
  for (int k = 0; k < 200; ++k)
  {
    const auto from = static_cast<Index>(random() % (mesh.vertexCount() - 1));
    const auto to = static_cast<Index>(random() % (mesh.vertexCount() - 1));
    const Index apart = std::abs(from % sides - to % sides);
    if (apart == sides / 2)
    {
      continue; // both ways are as long
    }
    const double r = slant * (1 + from / sides) / rings;
    const double s = slant * (1 + to / sides) / rings;
    const double turn = step * std::min(apart, sides - apart);
    const double exact = std::sqrt(r * r + s * s - 2.0 * r * s * std::cos(turn));
    const StraightPath path =
      straightPath(graph, vertexPoint(mesh, from + 1), vertexPoint(mesh, to + 1));
    EXPECT_NEAR(path.length, exact, rounding * slant) << from << " " << to;
  }
}

TEST(StraightPath, BendsRoundACornerOfTheBoundaryOnly)
{
  const TriangleMesh mesh = flatAngle();
  const Index from = vertexAt(mesh, Point3(5.0, 12.0, 0.0));
  const Index to = vertexAt(mesh, Point3(12.0, 3.0, 0.0));
  const StraightPath path =
    straightPath(PathGraph(mesh), vertexPoint(mesh, from), vertexPoint(mesh, to));
  EXPECT_NEAR(path.length, std::hypot(1.0, 6.0) + std::hypot(6.0, 3.0), 1e-12);
  EXPECT_LE(worstBend(mesh, path.path), rounding);
}

TEST(StraightPath, GoesAlongEdgesWhereTheyAreStraight)
{
  const Surface surface = unitSquares(20, 20);
  const StraightPath path = straightPath(PathGraph(surface.mesh), vertexPoint(surface.mesh, 3 * 21),
    vertexPoint(surface.mesh, 3 * 21 + 20));
  EXPECT_EQ(path.path.points.size(), 21U);
  for (const SurfacePoint& point : path.path.points)
  {
    EXPECT_EQ(point.type, SurfacePointType::Vertex);
  }
}

TEST(StraightPath, IsTheSegmentWithinATriangle)
{
  const Surface surface = cushion(4, 4, 0.3);
  std::mt19937 random(1);
  const SurfacePoint vertex = vertexPoint(surface.mesh, surface.mesh.triangle(7)[1]);
  SurfacePoint inside = randomPoint(surface.mesh, random);
  while (inside.type != SurfacePointType::Face || inside.id != 7)
  {
    inside = randomPoint(surface.mesh, random);
  }
  const PathGraph graph(surface.mesh);
  const StraightPath path = straightPath(graph, vertex, inside);
  EXPECT_EQ(path.path.triangles, Indices{ 7 });
  EXPECT_EQ(path.length, (vertex.position - inside.position).norm());
  const StraightPath point = straightPath(graph, inside, inside);
  EXPECT_TRUE(point.status.ok());
  EXPECT_EQ(point.length, 0.0);
}

TEST(StraightPath, StaysTheSameUnderMotionScaleAndRenumbering)
{
  const Surface surface = cushion(30, 30, 0.8);
  const PathGraph graph(surface.mesh);
  std::mt19937 random(3);
  Indices place;
  const Surface other = renumbered(surface, random, place);
  const PathGraph otherGraph(other.mesh);
  const Eigen::AngleAxisd turn(1.1, Point3(1.0, -2.0, 0.5).normalized());
  for (const double scale : { 1e-3, 1e3 })
  {
    const TriangleMesh mesh = moved(surface.mesh,
      [&](const Point3& p) -> Point3 { return scale * (turn * p + Point3(1.0, 2.0, 3.0)); });
    const PathGraph movedGraph(mesh);
    for (int k = 0; k < 50; ++k)
    {
      const auto a = static_cast<Index>(random() % mesh.vertexCount());
      const auto b = static_cast<Index>(random() % mesh.vertexCount());
      const double length =
        straightPath(graph, vertexPoint(surface.mesh, a), vertexPoint(surface.mesh, b)).length;
      EXPECT_NEAR(straightPath(movedGraph, vertexPoint(mesh, a), vertexPoint(mesh, b)).length,
        scale * length, 1e-9 * scale);
      EXPECT_NEAR(straightPath(otherGraph, vertexPoint(other.mesh, place[a]),
                    vertexPoint(other.mesh, place[b]))
                    .length,
        length, 1e-9);
      EXPECT_NEAR(
        straightPath(graph, vertexPoint(surface.mesh, b), vertexPoint(surface.mesh, a)).length,
        length, 1e-9);
    }
  }
}

TEST(StraightPath, StaysOnItsSideOfABumpWhileAnEndIsDragged)
{
  // A peak with a path past it; the end goes behind the peak, to where the other side is shorter.
  const Surface surface = patch(40, 40, [](double i, double j) {
    const double r = std::hypot(i - 20.0, j - 20.0) / 8.0;
    return Point3(i, j, 25.0 * std::exp(-r * r));
  });
  const TriangleMesh& mesh = surface.mesh;
  const PathGraph graph(mesh);
  const auto at = [&mesh](Index i, Index j) { return vertexPoint(mesh, j * 41 + i); };
  const SurfacePoint start = at(20, 2);
  StraightPath path = straightPath(graph, start, at(27, 38));
  double farthest = 0.0;
  for (Index i = 26; i >= 13; --i)
  {
    const StraightPath next = straightPathNear(graph, path.path, start, at(i, 38));
    ASSERT_TRUE(next.status.ok()) << next.status.message;
    EXPECT_LE(worstBend(mesh, next.path), rounding);
    EXPECT_NEAR(next.length, path.length, 1.0 + 1e-9); // by the step of the end
    for (const SurfacePoint& point : next.path.points)
    {
      if (std::abs(point.position.y() - 20.0) < 3.0)
      {
        EXPECT_GT(point.position.x(), 20.0);
      }
    }
    path = next;
    farthest = path.length - straightPath(graph, start, at(i, 38)).length;
  }
  EXPECT_GT(farthest, 1.0);
  EXPECT_LT(straightPath(graph, start, at(13, 38)).path.points[20].position.x(), 20.0);
}

TEST(StraightPath, NearItselfIsItself)
{
  const Surface surface = cushion(25, 25, 0.6);
  const PathGraph graph(surface.mesh);
  std::mt19937 random(5);
  for (int k = 0; k < 50; ++k)
  {
    const SurfacePoint from = randomPoint(surface.mesh, random);
    const SurfacePoint to = randomPoint(surface.mesh, random);
    const StraightPath path = straightPath(graph, from, to);
    const StraightPath again = straightPathNear(graph, path.path, from, to);
    EXPECT_NEAR(again.length, path.length, 1e-12 * path.length);
    EXPECT_EQ(again.path.points.size(), path.path.points.size());
  }
}

TEST(StraightPath, RefusesWhatItCannotJoin)
{
  const TriangleMesh two({ Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(3, 0, 0),
                           Point3(4, 0, 0), Point3(3, 1, 0), Point3(9, 9, 9) },
    { { 0, 1, 2 }, { 3, 4, 5 } });
  const PathGraph graph(two);
  EXPECT_EQ(straightPath(graph, vertexPoint(two, 0), vertexPoint(two, 4)).status.code,
    StatusCode::CurveLeavesSurface);
  EXPECT_EQ(straightPath(graph, vertexPoint(two, 0), vertexPoint(two, 6)).status.code,
    StatusCode::InvalidPointId);
  EXPECT_EQ(straightPath(graph, { SurfacePointType::Face, 2 }, vertexPoint(two, 0)).status.code,
    StatusCode::InvalidPointId);
  const SurfacePath elsewhere{ { vertexPoint(two, 0), vertexPoint(two, 4) }, { 0 } };
  EXPECT_EQ(
    straightPathNear(graph, elsewhere, vertexPoint(two, 0), vertexPoint(two, 1)).status.code,
    StatusCode::InvalidCurve);
  const TriangleMesh nothing;
  EXPECT_EQ(straightPath(PathGraph(nothing), {}, {}).status.code, StatusCode::EmptySurface);
}

namespace
{
/// Surfaces that make it hard: equally long ways, bumps that no straight line sees, two parts.
std::vector<TriangleMesh> hardSurfaces(double scale = 1.0)
{
  const auto scaled = [scale](const TriangleMesh& mesh) {
    return moved(mesh, [scale](const Point3& p) -> Point3 { return scale * p; });
  };
  const TriangleMesh bumps = patch(40, 40, [](double i, double j) {
    return Point3(i, j, 5.0 * std::sin(0.9 * i) * std::sin(0.7 * j));
  }).mesh;
  Points3 points = bumps.points();
  Triangles triangles = bumps.triangles();
  for (const Point3& point : bumps.points())
  {
    points.push_back(point + Point3(0.0, 0.0, 1e9));
  }
  for (const Triangle& t : bumps.triangles())
  {
    const Index shift = bumps.vertexCount();
    triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  points.emplace_back(0.0, 0.0, -7.0); // of no triangle
  return { scaled(flatPatch(30, 30).mesh), scaled(cylinder(40, 20).mesh), scaled(bumps),
    scaled(TriangleMesh(points, triangles)) };
}

void expectSame(const SurfacePath& a, const SurfacePath& b)
{
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.triangles, b.triangles);
  for (std::size_t k = 0; k < a.points.size(); ++k)
  {
    EXPECT_EQ(a.points[k].position, b.points[k].position);
  }
}
}

TEST(PathSearch, ByEdgesIsAsLongAsAnotherFindsThem)
{
  for (const TriangleMesh& mesh : hardSurfaces())
  {
    const PathGraph graph(mesh);
    std::mt19937 random(12);
    const SurfacePoint from = randomPoint(mesh, random);
    PathSearch search(graph, from, PathArcs::Edges);
    for (int k = 0; k < 40; ++k)
    {
      const SurfacePoint to = randomPoint(mesh, random);
      const double length = lengthByEdges(mesh, from, to);
      const StraightPath path = pathByEdges(search, to);
      EXPECT_EQ(std::isfinite(length), path.status.ok());
      if (path.status.ok() && commonTriangle(mesh, from, to) == none)
      {
        EXPECT_NEAR(path.length, length, 1e-12 * length);
      }
    }
  }
}

TEST(PathSearch, TakesTheSameOfEquallyLongWaysInEveryUnit)
{
  const auto idsOfWay = [](const TriangleMesh& mesh, const PathGraph& graph, int seed) {
    std::mt19937 random(seed);
    const SurfacePoint from = randomPoint(mesh, random);
    const SurfacePoint to = randomPoint(mesh, random);
    Indices ids;
    for (const SurfacePoint& vertex : PathSearch(graph, from).geodesicTo(to).vertices)
    {
      ids.push_back(vertex.id);
    }
    return ids;
  };
  const std::vector<TriangleMesh> meshes = hardSurfaces();
  for (const double scale : { 1e-3, 0.3048, 1e3 })
  {
    const std::vector<TriangleMesh> scaled = hardSurfaces(scale);
    for (std::size_t m = 0; m < meshes.size(); ++m)
    {
      const PathGraph graph(meshes[m]);
      const PathGraph other(scaled[m]);
      for (int k = 0; k < 100; ++k)
      {
        EXPECT_EQ(idsOfWay(meshes[m], graph, k), idsOfWay(scaled[m], other, k)) << k;
      }
    }
  }
}

TEST(SegmentPreview, IsWhatIsDrawnThereWhateverWasShownBefore)
{
  for (const TriangleMesh& mesh : hardSurfaces())
  {
    const auto surface = std::make_shared<const DrawingSurface>(mesh);
    SegmentPreview preview(surface);
    std::mt19937 random(4);
    SurfacePoint from = randomPoint(mesh, random);
    for (int k = 0; k < 200; ++k)
    {
      if (k % 40 == 0)
      {
        from = randomPoint(mesh, random);
      }
      const SurfacePoint to = randomPoint(mesh, random);
      const auto kind = static_cast<SegmentKind>(random() % 4);
      const DrawnSegment shown = preview.draw(kind, from, to);
      const DrawnSegment drawn = drawSegment(*surface, kind, from, to);
      ASSERT_EQ(shown.status.code, drawn.status.code);
      expectSame(shown.path, drawn.path);
    }
  }
}
