// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/CurveImprint.h"

#include "Cut/SurfaceCut.h"
#include "TestMeshes.h"

#include <set>

using namespace flattening;
using testmeshes::moved;
using testmeshes::secondsOf;

namespace
{
/// A flat grid of n x n unit squares, each cut along its diagonal; vertex (i, j) is j (n + 1) + i.
TriangleMesh grid(Index n)
{
  return { testmeshes::unitSquares(n, n).mesh.points(), testmeshes::gridTriangles(n, n) };
}

Polyline polyline(Points3 points)
{
  Polyline result;
  result.points = std::move(points);
  for (std::size_t i = 0; i < result.points.size(); ++i)
  {
    result.pointIds.push_back(static_cast<Index>(100 + i));
  }
  return result;
}

double length(const TriangleMesh& mesh, const Indices& chain)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    sum += (mesh.point(chain[i]) - mesh.point(chain[i - 1])).norm();
  }
  return sum;
}

/// What holds for every imprint: the same surface, as a valid mesh, with each curve on its edges.
void expectSameSurface(const TriangleMesh& before, const ImprintedSurface& after)
{
  ASSERT_TRUE(after.status.ok()) << after.status.message;
  const TriangleMesh& mesh = after.mesh;
  const PreparedSurface valid =
    prepareSurface(mesh.points(), mesh.triangles(), CoincidentPoints::Join);
  ASSERT_TRUE(valid.status.ok()) << valid.status.message;
  EXPECT_TRUE(valid.reversedTriangles.empty());
  EXPECT_EQ(valid.mesh.vertexCount(), mesh.vertexCount());
  EXPECT_EQ(eulerCharacteristic(mesh), eulerCharacteristic(before));
  EXPECT_EQ(mesh.boundaryLoops().size(), before.boundaryLoops().size());

  ASSERT_EQ(after.originalTriangle.size(), mesh.triangles().size());
  std::vector<double> area(before.triangleCount(), 0.0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Index whole = after.originalTriangle[t];
    ASSERT_TRUE(whole >= 0 && whole < before.triangleCount());
    area[whole] += mesh.area(t);
  }
  for (Index t = 0; t < before.triangleCount(); ++t)
  {
    // Rounding of a triangle's own coordinates is all that may change its area.
    double longest = 0.0;
    double size = 0.0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      longest = std::max(longest, before.length(h));
      size = std::max(size, before.point(before.from(h)).norm());
    }
    EXPECT_NEAR(area[t], before.area(t), 1e-12 * before.area(t) + 1e-14 * longest * size);
  }

  ASSERT_EQ(after.vertexSource.size(), mesh.points().size());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const VertexSource& source = after.vertexSource[v];
    Point3 mean = Point3::Zero();
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_GE(source.weights[k], -1e-15);
      sum += source.weights[k];
      mean += source.weights[k] * before.point(source.vertices[k]);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_LE((mean - mesh.point(v)).norm(), 1e-15 * (1.0 + mean.norm()));
    if (v < before.vertexCount())
    {
      EXPECT_EQ(mesh.point(v), before.point(v));
    }
  }

  for (const FeatureCurve& curve : after.curves)
  {
    ASSERT_GE(curve.vertices.size(), 2u);
    for (std::size_t i = 1; i < curve.vertices.size(); ++i)
    {
      const Index a = curve.vertices[i - 1];
      const Index b = curve.vertices[i];
      EXPECT_TRUE(mesh.find(a, b) != none || mesh.find(b, a) != none);
    }
  }
}

/// Half a cylinder of radius one and height two, n by n.
TriangleMesh halfCylinder(Index n)
{
  return moved(grid(n), [n](const Point3& p) {
    const double angle = pi * p.x() / n;
    return Point3(std::cos(angle), std::sin(angle), 2.0 * p.y() / n);
  });
}

/// A torus of radii two and one half.
TriangleMesh ring(Index n)
{
  return moved(testmeshes::torus(n, 4.0), [](const Point3& p) -> Point3 { return 0.5 * p; });
}

/// A regular polygon, its first corner again as its last.
Polyline closedPolygon(const Point3& center, double radius, int corners)
{
  Points3 points;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = 2.0 * pi * (i % corners) / corners;
    points.push_back(center + radius * Point3(std::cos(angle), std::sin(angle), 0));
  }
  return polyline(std::move(points));
}

/// The same curve, and drawn from its other end.
std::array<Polyline, 2> bothWays(const Points3& points)
{
  return { polyline(points), polyline({ points.rbegin(), points.rend() }) };
}
}

TEST(CurveImprint, ACurveAlongEdgesBecomesItsVerticesAndLeavesTheMeshUnchanged)
{
  const TriangleMesh mesh = grid(4);
  const auto result = imprintCurves(
    mesh, { polyline({ Point3(0, 1, 0), Point3(1, 1, 0), Point3(1, 1, 0), Point3(2, 2, 0) }) }, {});
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_EQ(result.curves[0].vertices, (Indices{ 5, 6, 12 }));
  EXPECT_EQ(result.mesh.points(), mesh.points());
  EXPECT_EQ(result.mesh.triangles(), mesh.triangles());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_EQ(result.vertexSource[v].vertices[0], v);
    EXPECT_EQ(result.vertexSource[v].weights, (std::array<double, 3>{ 1.0, 0.0, 0.0 }));
  }
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    EXPECT_EQ(result.originalTriangle[t], t);
  }
}

TEST(CurveImprint, AStraightLineAcrossAFlatMeshStaysStraightAndKeepsItsLength)
{
  const TriangleMesh mesh = grid(10);
  const Point3 a(0.31, 0.17, 0);
  const Point3 b(9.64, 7.83, 0);
  const auto result = imprintCurves(mesh, { polyline({ a, b }) }, {});
  expectSameSurface(mesh, result);
  const Indices& chain = result.curves[0].vertices;
  // It crosses 9 lines x = i, 7 lines y = j and the diagonal x - y = 1.
  EXPECT_EQ(chain.size(), 19u);
  EXPECT_NEAR(length(result.mesh, chain), (b - a).norm(), 1e-14 * (b - a).norm());
  const Point3 way = (b - a).normalized();
  for (Index v : chain)
  {
    EXPECT_LE(way.cross(result.mesh.point(v) - a).norm(), 1e-14);
  }
}

TEST(CurveImprint, ASegmentAcrossTheRulingsOfACylinderIsAsLongAsItsEllipse)
{
  const TriangleMesh mesh = halfCylinder(200);
  // Both ends are on the mesh's edges, one on a ruling each.
  const Point3 a(std::cos(0.25 * pi), std::sin(0.25 * pi), 0.503);
  const Point3 b(std::cos(0.5 * pi), std::sin(0.5 * pi), 1.307);
  const auto result = imprintCurves(mesh, { polyline({ a, b }) }, {});
  expectSameSurface(mesh, result);
  // The plane through a and b that holds the mean normal cuts the cylinder in an ellipse.
  const Point3 normal = (b - a).cross(Point3(a.x() + b.x(), a.y() + b.y(), 0.0));
  double ellipse = 0.0;
  Point3 last = a;
  for (int i = 1; i <= 100000; ++i)
  {
    const double angle = 0.25 * pi + 0.25 * pi * i / 100000;
    Point3 p(std::cos(angle), std::sin(angle), 0.0);
    p.z() = a.z() - normal.head<2>().dot((p - a).head<2>()) / normal.z();
    ellipse += (p - last).norm();
    last = p;
  }
  // Chords of 0.9 degrees are 1e-5 shorter than arcs.
  EXPECT_NEAR(length(result.mesh, result.curves[0].vertices), ellipse, 2e-5 * ellipse);
}

TEST(CurveImprint, ALineAlongARulingOrAcrossACylinderHasTheLengthOfTheSection)
{
  const Index n = 36;
  const TriangleMesh mesh = halfCylinder(n);
  const double half = 0.5 * pi / n;
  // Along the middle of a strip of flat quadrilaterals, and along a circle between two rows.
  const Point3 foot = std::cos(half) * Point3(std::cos(15 * half), std::sin(15 * half), 0.0);
  const auto ruling =
    imprintCurves(mesh, { polyline({ foot + Point3(0, 0, 0.01), foot + Point3(0, 0, 1.99) }) }, {});
  expectSameSurface(mesh, ruling);
  EXPECT_NEAR(length(ruling.mesh, ruling.curves[0].vertices), 1.98, 1e-13);
  Points3 arc;
  for (Index i = 2; i <= n - 2; i += 4)
  {
    arc.push_back(Point3(std::cos(pi * i / n), std::sin(pi * i / n), 1.02));
  }
  const auto circle = imprintCurves(mesh, { polyline(arc) }, {});
  expectSameSurface(mesh, circle);
  EXPECT_NEAR(length(circle.mesh, circle.curves[0].vertices),
    2.0 * std::sin(half) * 4 * (arc.size() - 1), 1e-13);
}

TEST(CurveImprint, CrossingCurvesShareOneVertex)
{
  const TriangleMesh mesh = grid(8);
  const Polyline one = polyline({ Point3(0.3, 0.2, 0), Point3(7.6, 7.1, 0) });
  const Polyline two = polyline({ Point3(0.4, 7.3, 0), Point3(7.7, 0.35, 0) });
  const auto result = imprintCurves(mesh, { one, two }, {});
  expectSameSurface(mesh, result);
  Indices shared;
  const Indices& other = result.curves[1].vertices;
  std::copy_if(result.curves[0].vertices.begin(), result.curves[0].vertices.end(),
    std::back_inserter(shared),
    [&](Index v) { return std::count(other.begin(), other.end(), v) > 0; });
  ASSERT_EQ(shared.size(), 1u);
  // Intersection of the two lines.
  const Point2 u(7.3, 6.9);
  const Point2 w(7.3, -6.95);
  const Point2 d(0.1, 7.1);
  const double s = (d.x() * w.y() - d.y() * w.x()) / (u.x() * w.y() - u.y() * w.x());
  EXPECT_LE((result.mesh.point(shared[0]).head<2>() - (Point2(0.3, 0.2) + s * u)).norm(), 1e-13);
  EXPECT_NEAR(length(result.mesh, result.curves[0].vertices), u.norm(), 1e-13);
  EXPECT_NEAR(length(result.mesh, result.curves[1].vertices), w.norm(), 1e-13);
}

TEST(CurveImprint, CurvesThatCrossInsideOneTriangleShareAVertexThere)
{
  const TriangleMesh mesh = grid(1);
  const Polyline one = polyline({ Point3(0.5, 0.1, 0), Point3(0.9, 0.5, 0) });
  const Polyline two = polyline({ Point3(0.5, 0.3, 0), Point3(0.9, 0.2, 0) });
  const auto result = imprintCurves(mesh, { one, two }, {});
  expectSameSurface(mesh, result);
  EXPECT_EQ(result.curves[0].vertices.size(), 3u);
  EXPECT_EQ(result.curves[1].vertices.size(), 3u);
  EXPECT_EQ(result.curves[0].vertices[1], result.curves[1].vertices[1]);
}

TEST(CurveImprint, ACurveHasVerticesOnlyAtItsPointsAndWhereItCrossesEdges)
{
  // Points of a second curve inside the same triangles must not add vertices to the first.
  const TriangleMesh mesh = grid(2);
  const Polyline one = polyline({ Point3(0.3, 0.1, 0), Point3(1.9, 0.15, 0) });
  Points3 cloud;
  for (int i = 0; i < 20; ++i)
  {
    cloud.push_back(Point3(0.5 + 0.02 * i, 0.3 + 0.1 * (i % 2), 0));
  }
  const auto result = imprintCurves(mesh, { polyline(cloud), one }, {});
  expectSameSurface(mesh, result);
  // Crossed: the ruling x = 1 and the diagonal of the second square.
  EXPECT_EQ(result.curves[1].vertices.size(), 4u);
}

TEST(CurveImprint, AClosedCurveStaysClosedAndNoSegmentRunsToAVertexBeyondItsEndAndBack)
{
  // The circle of radius 5 passes 12 vertices, such as (10, 9), within triangles that its points
  // lie in, too.
  for (const double unit : { 1e-3, 1.0, 40.0 })
  {
    const TriangleMesh mesh = moved(grid(12), [unit](const Point3& p) { return unit * p; });
    for (const int count : { 40, 100, 128, 256, 512, 1000 })
    {
      SCOPED_TRACE(testing::Message() << unit << ", " << count);
      const auto result =
        imprintCurves(mesh, { closedPolygon(unit * Point3(6, 6, 0), 5.0 * unit, count) }, {});
      expectSameSurface(mesh, result);
      const FeatureCurve& curve = result.curves[0];
      EXPECT_TRUE(curve.closed());
      EXPECT_NEAR(length(result.mesh, curve.vertices), 10.0 * pi * unit, 0.02 * pi * unit);
      const std::set<Index> different(curve.vertices.begin(), curve.vertices.end());
      EXPECT_EQ(different.size() + 1, curve.vertices.size());
    }
  }
}

TEST(CurveImprint, PointsNearVerticesAndEdgesMoveOntoThemSoThatNoSliverArises)
{
  const TriangleMesh mesh = grid(6);
  ImprintOptions options;
  options.snap = 0.02;
  // It passes (1, 1) .. (5, 5) at less than 0.02 and runs beside the line y = 0 at 0.01.
  const auto result = imprintCurves(mesh,
    { polyline({ Point3(0.4, 0.41, 0), Point3(5.6, 5.62, 0) }),
      polyline({ Point3(0.5, 0.01, 0), Point3(5.5, 0.01, 0) }) },
    options);
  expectSameSurface(mesh, result);
  for (Index v : result.curves[1].vertices)
  {
    EXPECT_EQ(result.mesh.point(v).y(), 0.0);
  }
  for (Index h = 0; h < result.mesh.halfedgeCount(); ++h)
  {
    EXPECT_GT(result.mesh.angle(h), 0.02);
  }
}

TEST(CurveImprint, ThePlanarShapeOfAKeyCurveIsInterpolatedAlongItsLength)
{
  const TriangleMesh mesh = grid(4);
  Polyline key = polyline({ Point3(0.5, 0.2, 0), Point3(3.5, 0.2, 0), Point3(3.5, 3.3, 0) });
  key.type = CurveType::Key;
  key.keyShape = KeyShape::Planar;
  for (const Point3& p : key.points)
  {
    key.planarShape.push_back(Point2(-p.y(), p.x()));
  }
  const auto result = imprintCurves(mesh, { key }, {});
  expectSameSurface(mesh, result);
  const FeatureCurve& curve = result.curves[0];
  ASSERT_EQ(curve.planarShape.size(), curve.vertices.size());
  for (std::size_t i = 0; i < curve.vertices.size(); ++i)
  {
    const Point3& p = result.mesh.point(curve.vertices[i]);
    EXPECT_LE((curve.planarShape[i] - Point2(-p.y(), p.x())).norm(), 1e-14);
  }
}

TEST(CurveImprint, UnitsOfLengthAndPlaceDoNotMatter)
{
  const Polyline line = polyline({ Point3(0.31, 0.17, 0), Point3(4.6, 3.8, 0), Point3(2, 0.7, 0) });
  const auto reference = imprintCurves(grid(5), { line }, {});
  for (double scale : { 1e-9, 1e9 })
  {
    const TriangleMesh mesh =
      moved(grid(5), [scale](const Point3& p) { return Point3(scale * p); });
    Polyline scaled = line;
    for (Point3& p : scaled.points)
    {
      p *= scale;
    }
    const auto result = imprintCurves(mesh, { scaled }, {});
    expectSameSurface(mesh, result);
    EXPECT_EQ(result.curves[0].vertices, reference.curves[0].vertices);
    EXPECT_EQ(result.mesh.triangles(), reference.mesh.triangles());
  }
}

TEST(CurveImprint, CurvesOnTheEdgesOfAMillionTrianglesCostLittleMoreThanToBuildTheMesh)
{
  const Index n = 700;
  const TriangleMesh mesh = grid(n);
  Points3 points;
  for (Index i = 0; i <= n; ++i)
  {
    points.push_back(Point3(i, n / 2, 0));
  }
  // The best of three, for other programs run beside this one.
  double build = std::numeric_limits<double>::infinity();
  double imprint = build;
  for (int run = 0; run < 3; ++run)
  {
    build = std::min(build, secondsOf([&] { TriangleMesh(mesh.points(), mesh.triangles()); }));
    ImprintedSurface result;
    imprint =
      std::min(imprint, secondsOf([&] { result = imprintCurves(mesh, { polyline(points) }, {}); }));
    ASSERT_TRUE(result.status.ok());
    EXPECT_EQ(result.mesh.triangles(), mesh.triangles());
  }
  EXPECT_LT(imprint, 2.0 * build);
}

TEST(CurveImprint, TakesPicksThatLieALittleOffTheSurface)
{
  const TriangleMesh mesh = grid(10);
  const double diagonal = 10.0 * std::sqrt(2.0);
  Polyline line = polyline({ Point3(1.2, 1.3, 1e-3 * diagonal), Point3(5.4, 3.3, -1e-3 * diagonal),
    Point3(8.2, 7.7, 1e-3 * diagonal) });
  EXPECT_TRUE(imprintCurves(mesh, { line }, {}).status.ok());
  // Farther off the message gives the distance and the number that takes it, and this does.
  line.points[2].z() = 0.01313 * diagonal;
  const auto refused = imprintCurves(mesh, { line }, {});
  ASSERT_EQ(refused.status.code, StatusCode::CurvePointOffSurface);
  EXPECT_EQ(refused.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 102 } }));
  EXPECT_NE(refused.status.message.find("0.1857"), std::string::npos) << refused.status.message;
  ASSERT_EQ(refused.status.remedies.size(), 2U);
  EXPECT_EQ(refused.status.remedies[1].remedy, Remedy::RaiseImprintTolerance);
  EXPECT_EQ(refused.status.remedies[1].subject, "0.014");
  ImprintOptions options;
  options.tolerance = std::stod(refused.status.remedies[1].subject);
  const auto taken = imprintCurves(mesh, { line }, options);
  ASSERT_TRUE(taken.status.ok()) << taken.status.message;
  const Point3 end = taken.mesh.point(taken.curves[0].vertices.back());
  EXPECT_LE((end - Point3(8.2, 7.7, 0)).norm(), 1e-15);
  // A tenth of the diagonal away none is given: it would lay down curves of another unit.
  EXPECT_EQ(refused.status.message.find("differ"), std::string::npos) << refused.status.message;
  line.points[2].z() = 0.11 * diagonal;
  const auto far = imprintCurves(mesh, { line }, {});
  EXPECT_EQ(far.status.remedies.size(), 1U);
  EXPECT_NE(far.status.message.find("differ in unit"), std::string::npos) << far.status.message;
}

TEST(CurveImprint, KeepsACurveOnOnePartWherePartsTouchWithoutBeingJoined)
{
  // Three sheets of 5 x 5 side by side, each with points of its own on the lines between them.
  std::vector<testmeshes::Surface> sheets;
  for (double x : { 0.0, 5.0, 10.0 })
  {
    sheets.push_back(
      testmeshes::patch(5, 5, [x](double i, double j) { return Point3(x + i, j, 0.0); }));
  }
  const TriangleMesh mesh = testmeshes::together(sheets).mesh;
  for (double y : { 2.0, 2.3 })
  {
    for (double x : { 0.0, 5.0, 10.0 })
    {
      for (const Polyline& line :
        bothWays({ Point3(x, y, 0.0), Point3(x + 2.5, y, 0.0), Point3(x + 5.0, 5.0 - y, 0.0) }))
      {
        const ImprintedSurface surface = imprintCurves(mesh, { line }, {});
        ASSERT_TRUE(surface.status.ok()) << surface.status.message;
        Indices part;
        connectedParts(surface.mesh, {}, part);
        for (Index v : surface.curves[0].vertices)
        {
          EXPECT_EQ(part[surface.mesh.outgoing(v) / 3], std::lround(x / 5.0));
        }
      }
    }
  }
  // From one sheet to the next it cannot run.
  EXPECT_EQ(imprintCurves(mesh, { polyline({ Point3(2, 2, 0), Point3(7, 2, 0) }) }, {}).status.code,
    StatusCode::CurveLeavesSurface);
}

TEST(CurveImprint, KeepsACurveOnThePartItLiesOnBesideVerticesOfAnother)
{
  const double gap = 0.005; // nearer than what moves a point onto a vertex
  const TriangleMesh mesh = testmeshes::together(
    { testmeshes::patch(6, 6, [](double i, double j) { return Point3(i, j, 0.0); }),
      testmeshes::patch(6, 6, [gap](double i, double j) {
        return Point3(i - 0.4, j - 0.3, gap);
      }) }).mesh;
  Points3 points;
  for (double y = 1.0; y < 5.0; y += 0.5)
  {
    points.emplace_back(3.0, y, gap);
  }
  for (const Polyline& line : bothWays(points))
  {
    const ImprintedSurface surface = imprintCurves(mesh, { line }, {});
    ASSERT_TRUE(surface.status.ok()) << surface.status.message;
    for (Index v : surface.curves[0].vertices)
    {
      EXPECT_NEAR(surface.mesh.point(v).z(), gap, 1e-12);
    }
  }
}

TEST(CurveImprint, KeepsACurveOnItsSideOfASlit)
{
  // A sheet that is slit from its left edge to its middle, both sides in one place.
  const TriangleMesh whole = grid(8);
  Polyline slit = polyline({ Point3(0, 4, 0), Point3(4, 4, 0) });
  slit.type = CurveType::Dart;
  const ImprintedSurface imprinted = imprintCurves(whole, { slit }, {});
  ASSERT_TRUE(imprinted.status.ok());
  const TriangleMesh mesh = cutSurface(imprinted.mesh, imprinted.curves).mesh;
  ASSERT_EQ(mesh.vertexCount(), whole.vertexCount() + 4);
  for (double x : { 1.0, 2.0, 2.3 })
  {
    for (double end : { 0.0, 8.0 })
    {
      Points3 points;
      for (int k = 0; k <= 40; ++k)
      {
        points.emplace_back(x, 4.0 + (end - 4.0) * k / 40.0, 0.0);
      }
      for (const Polyline& line : bothWays(points))
      {
        const ImprintedSurface surface = imprintCurves(mesh, { line }, {});
        ASSERT_TRUE(surface.status.ok()) << surface.status.message;
        EXPECT_NEAR(length(surface.mesh, surface.curves[0].vertices), 4.0, 1e-9);
      }
    }
  }
}

TEST(CurveImprint, GoesToTheNearestVertexWhereNothingIsSplit)
{
  const TriangleMesh mesh = grid(10);
  ImprintOptions options;
  options.split = false;
  options.tolerance = 1.0; // every vertex is within it
  const auto result = imprintCurves(mesh,
    { polyline({ Point3(1.2, 1.3, 0.1), Point3(1.9, 1.1, 0.2), Point3(3.3, 0.8, 0.0) }) }, options);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_EQ(result.curves[0].vertices, (Indices{ 12, 13, 14 }));
}

TEST(CurveImprintRefusal, APointTooFarToMeasureIsRefusedLikeOneThatIsNoNumber)
{
  for (const double far : { 1e200, std::numeric_limits<double>::infinity() })
  {
    const auto result =
      imprintCurves(grid(4), { polyline({ Point3(0, 0, 0), Point3(1, far, 0) }) }, {});
    EXPECT_EQ(result.status.code, StatusCode::NonFinitePoint);
    EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 101 } }));
  }
}

TEST(CurveImprintRefusal, ASegmentThatLeavesTheSurfaceIsRefusedWithItsPoints)
{
  // A horseshoe: the grid without the middle of its lower half.
  const TriangleMesh mesh = testmeshes::partWhere(grid(6), [](const Point3& p) {
    return p.x() < 2 || p.x() > 4 || p.y() > 3;
  }).mesh;
  const Polyline bad = polyline({ Point3(0.2, 0.3, 0), Point3(1.1, 1.4, 0), Point3(5.1, 1.6, 0) });
  const auto result = imprintCurves(mesh, { bad }, {});
  EXPECT_EQ(result.status.code, StatusCode::CurveLeavesSurface);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 101, 102 } }));
  EXPECT_NE(result.status.message.find("(2, "), std::string::npos) << result.status.message;
  EXPECT_EQ(result.mesh.triangleCount(), 0);
}

TEST(CurveImprintRefusal, ASegmentThatNoSectionOfTheSurfaceJoinsIsRefusedWithItsPoints)
{
  // From the outside of a ring to its inside, half-way around: the planes through both that follow
  // a normal cut separate circles out of it.
  const TriangleMesh mesh = ring(24);
  const auto result = imprintCurves(mesh, { polyline({ mesh.point(0), mesh.point(300) }) }, {});
  EXPECT_EQ(result.status.code, StatusCode::CurveLeavesSurface);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 100, 101 } }));
  EXPECT_NE(result.status.message.find("cannot be followed"), std::string::npos)
    << result.status.message;
  // Half-way around on the outside a plane section joins the two.
  const auto around = imprintCurves(mesh, { polyline({ mesh.point(0), mesh.point(288) }) }, {});
  expectSameSurface(mesh, around);
  EXPECT_NEAR(length(around.mesh, around.curves[0].vertices), 2.5 * 24 * std::sin(pi / 24), 1e-12);
}

TEST(CurveImprintRefusal, ASegmentBetweenSeparatePartsIsRefusedWithItsPointsAndTheParts)
{
  // Grids of three sizes beside each other; by vertices and between them, split or not.
  std::vector<testmeshes::Surface> parts;
  for (const Index n : { 2, 5, 3 })
  {
    parts.emplace_back().mesh =
      moved(grid(n), [n](const Point3& p) -> Point3 { return p + Point3(10.0 * n, 0, 0); });
  }
  const TriangleMesh whole = testmeshes::together(parts).mesh;
  for (const double scale : { 1e-3, 1.0, 1e4 })
  {
    const TriangleMesh mesh = moved(whole, [&](const Point3& p) { return Point3(scale * p); });
    const auto curve = [&](double x, double y) {
      return polyline({ scale * Point3(20, y, 0), scale * Point3(21, y, 0), scale * Point3(x, y, 0),
        scale * Point3(x + 1, y, 0) });
    };
    for (const bool split : { true, false })
    {
      ImprintOptions options;
      options.split = split;
      for (const auto& [x, sizes] : { std::pair(31.0, "8 and 18"), std::pair(52.0, "8 and 50") })
      {
        for (const double y : { 0.0, 1.0, 0.37 })
        {
          if (!split && y == 0.37)
          {
            continue; // no vertices
          }
          const Status status = imprintCurves(mesh, { curve(x, y) }, options).status;
          EXPECT_EQ(status.code, StatusCode::CurveLeavesSurface);
          EXPECT_EQ(status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 101, 102 } }));
          EXPECT_EQ(status.curve, 0);
          EXPECT_NE(
            status.message.find("points 101 and 102 lie on separate parts of the surface, of " +
              std::string(sizes) + " triangles"),
            std::string::npos)
            << status.message;
          ASSERT_EQ(status.remedies.size(), 2U);
          EXPECT_EQ(status.remedies[0].remedy, Remedy::RedrawCurve);
          EXPECT_EQ(status.remedies[1].remedy, Remedy::JoinByEdge);
        }
      }
    }
  }
}

namespace
{
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A point of the surface: a vertex, one on an edge, one inside, or one very near to the others.
Point3 randomPoint(const TriangleMesh& mesh, Random& random)
{
  const Index t = static_cast<Index>(random() % mesh.triangleCount());
  double u = uniform(random, 0.0, 1.0);
  double v = uniform(random, 0.0, 1.0);
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  // What its weights are multiplied by.
  const std::array<Point2, 6> places{ Point2(0, 0), Point2(0, 1), Point2(3e-3, 1),
    Point2(2e-3, 2e-3), Point2(1, 1), Point2(1, 1) };
  const Point2& place = places[random() % places.size()];
  u *= place.x();
  v *= place.y();
  const Triangle& c = mesh.triangle(t);
  return (1.0 - u - v) * mesh.point(c[0]) + u * mesh.point(c[1]) + v * mesh.point(c[2]);
}

TriangleMesh randomSurface(Random& random)
{
  const Index n = 2 + static_cast<Index>(random() % 9);
  const TriangleMesh flat = moved(grid(n), [&random, n](const Point3& p) {
    const bool inner = p.x() > 0 && p.x() < n && p.y() > 0 && p.y() < n;
    const double d = inner ? 0.3 : 0.0;
    return Point3((p.x() + uniform(random, -d, d)) / n, (p.y() + uniform(random, -d, d)) / n, 0.0);
  });
  const double a = uniform(random, 0.0, 0.3);
  const double f = uniform(random, 0.5, 6.0);
  // Some are squeezed until their triangles are needles.
  const double squeeze = random() % 4 == 0 ? std::pow(10.0, uniform(random, -9.0, 0.0)) : 1.0;
  return moved(flat, [a, f, squeeze](const Point3& p) {
    return Point3(p.x(), squeeze * p.y(), a * std::sin(f * p.x()) * std::cos(f * squeeze * p.y()));
  });
}
}

TEST(CurveImprint, NoRandomCurvesOnRandomSurfacesBreakTheMesh)
{
  Random random(20080301);
  int done = 0;
  const int cases = 600;
  for (int k = 0; k < cases && !HasFailure(); ++k)
  {
    SCOPED_TRACE("case " + std::to_string(k));
    const TriangleMesh mesh = k % 10 == 9 ? ring(9 + k % 7) : randomSurface(random);
    std::vector<Polyline> curves(1 + random() % 5);
    for (Polyline& curve : curves)
    {
      const std::size_t count = 2 + random() % 6;
      while (curve.points.size() < count)
      {
        curve.points.push_back(randomPoint(mesh, random));
      }
    }
    ImprintOptions options;
    options.snap = std::pow(10.0, uniform(random, -4.0, -0.8));
    const auto result = imprintCurves(mesh, curves, options);
    if (result.status.code == StatusCode::CurveLeavesSurface ||
      result.status.code == StatusCode::CurveTooShort)
    {
      continue;
    }
    ++done;
    expectSameSurface(mesh, result);
    const auto again = imprintCurves(mesh, curves, options);
    EXPECT_EQ(again.mesh.triangles(), result.mesh.triangles());
  }
  EXPECT_GT(done, cases / 2);
}
