// SPDX-License-Identifier: BSD-3-Clause
// What is no curve on the surface is refused with the ids of its points.
#include "ImprintTesting.h"
#include "TestMeshes.h"

#include <limits>
#include <string>
#include <utility>

using namespace flattening;
using namespace imprinttesting;

TEST(CurveImprintRefusal, ASegmentThatIsNoEdgeIsRefusedWithItsPointsWhereSplittingIsOff)
{
  ImprintOptions options;
  options.split = false;
  const auto result =
    imprintCurves(grid(4), { polyline({ Point3(0, 0, 0), Point3(2, 1, 0) }) }, options);
  EXPECT_EQ(result.status.code, StatusCode::CurveNotOnEdges);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 100, 101 } }));
}

TEST(CurveImprintRefusal, APointTooFarToMeasureIsRefusedLikeOneThatIsNoNumber)
{
  const auto result =
    imprintCurves(grid(4), { polyline({ Point3(0, 0, 0), Point3(1, 1e200, 0) }) }, {});
  EXPECT_EQ(result.status.code, StatusCode::NonFinitePoint);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 101 } }));
}

TEST(CurveImprintRefusal, ACurveWithoutTwoDifferentPointsIsRefusedWithItsId)
{
  const Polyline good = polyline({ Point3(0, 0, 0), Point3(1, 0, 0) });
  const Polyline bad = polyline({ Point3(1, 1, 0), Point3(1, 1, 0) });
  const auto result = imprintCurves(grid(4), { good, bad }, {});
  EXPECT_EQ(result.status.code, StatusCode::CurveTooShort);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::Curves, Indices{ 1 } }));
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

TEST(CurveImprintRefusal, APointOffTheSurfaceIsRefusedWithItsDistance)
{
  const auto result =
    imprintCurves(grid(4), { polyline({ Point3(0.3, 0.4, 0), Point3(1.2, 1.1, 0.25) }) }, {});
  EXPECT_EQ(result.status.code, StatusCode::CurvePointOffSurface);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 101 } }));
  EXPECT_NE(result.status.message.find("0.25"), std::string::npos) << result.status.message;
  ImprintOptions wide;
  wide.tolerance = 0.1;
  const auto projected =
    imprintCurves(grid(4), { polyline({ Point3(0.3, 0.4, 0), Point3(1.2, 1.1, 0.25) }) }, wide);
  ASSERT_TRUE(projected.status.ok()) << projected.status.message;
  const Point3 end = projected.mesh.point(projected.curves[0].vertices.back());
  EXPECT_LE((end - Point3(1.2, 1.1, 0)).norm(), 1e-15);
}

TEST(CurveImprintRefusal, ASegmentThatNoSectionOfTheSurfaceJoinsIsRefusedWithItsPoints)
{
  // From the outside of a ring to its inside, half-way around: the planes through both that follow
  // a normal cut separate circles out of it.
  const TriangleMesh mesh = torus(24);
  const auto result = imprintCurves(mesh, { polyline({ mesh.point(0), mesh.point(300) }) }, {});
  EXPECT_EQ(result.status.code, StatusCode::CurveLeavesSurface);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 100, 101 } }));
  EXPECT_NE(result.status.message.find("cannot be followed"), std::string::npos)
    << result.status.message;
  // Half-way around on the outside a plane section joins the two.
  const auto around = imprintCurves(mesh, { polyline({ mesh.point(0), mesh.point(12) }) }, {});
  expectSameSurface(mesh, around);
  EXPECT_NEAR(length(around.mesh, around.curves[0].vertices), 2.5 * 24 * std::sin(pi / 24), 1e-12);
}

TEST(CurveImprintRefusal, ASegmentBetweenSeparatePartsIsRefusedWithItsPointsAndTheParts)
{
  // Grids of three sizes beside each other; by vertices and between them, split or not.
  std::vector<testmeshes::Surface> parts;
  for (const Index n : { 2, 5, 3 })
  {
    parts.emplace_back().mesh = testmeshes::moved(
      grid(n), [n](const Point3& p) -> Point3 { return p + Point3(10.0 * n, 0, 0); });
  }
  const TriangleMesh whole = testmeshes::together(parts).mesh;
  for (const double scale : { 1e-3, 1.0, 1e4 })
  {
    const TriangleMesh mesh = mapped(whole, [&](const Point3& p) { return Point3(scale * p); });
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

TEST(CurveImprintRefusal, ACancelledRunGivesNothing)
{
  Execution execution;
  execution.cancel = [] { return true; };
  const auto result = imprintCurves(
    grid(4), { polyline({ Point3(0.3, 0.4, 0), Point3(1.2, 1.1, 0) }) }, {}, execution);
  EXPECT_EQ(result.status.code, StatusCode::Cancelled);
  EXPECT_EQ(result.mesh.triangleCount(), 0);
}

TEST(CurveImprintRefusal, AnOptionOutsideItsRangeAndAPlanarShapeOfOtherLengthAreRefused)
{
  const Polyline line = polyline({ Point3(0, 0, 0), Point3(1, 0, 0) });
  ImprintOptions options;
  options.snap = 0.6;
  EXPECT_EQ(imprintCurves(grid(2), { line }, options).status.code, StatusCode::InvalidOption);
  options = {};
  options.tolerance = -1.0;
  EXPECT_EQ(imprintCurves(grid(2), { line }, options).status.code, StatusCode::InvalidOption);
  Polyline key = line;
  key.keyShape = KeyShape::Planar;
  key.planarShape = { Point2(0, 0) };
  EXPECT_EQ(imprintCurves(grid(2), { key }, {}).status.code, StatusCode::InvalidCurve);
  Polyline infinite = line;
  infinite.points[1].y() = std::numeric_limits<double>::infinity();
  const auto result = imprintCurves(grid(2), { infinite }, {});
  EXPECT_EQ(result.status.code, StatusCode::NonFinitePoint);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::CurvePoints, Indices{ 101 } }));
}
