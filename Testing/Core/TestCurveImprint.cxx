// SPDX-License-Identifier: BSD-3-Clause
#include "CurveImprint.h"

#include "SurfacePreparation.h"

#include <gtest/gtest.h>

using namespace flattening;

namespace
{
/// A flat grid of n x n unit squares, each cut along its diagonal; vertex (i, j) is j (n + 1) + i.
TriangleMesh grid(Index n)
{
  Points3 points;
  Triangles triangles;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      points.push_back(Point3(i, j, 0.0));
    }
  }
  for (Index j = 0; j < n; ++j)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Index a = j * (n + 1) + i;
      triangles.push_back({ a, a + 1, a + n + 2 });
      triangles.push_back({ a, a + n + 2, a + n + 1 });
    }
  }
  return prepareSurface(points, triangles).mesh;
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

TEST(CurveImprint, ASegmentThatIsNoEdgeIsRefusedWithItsPointsWhereSplittingIsOff)
{
  ImprintOptions options;
  options.split = false;
  const auto result =
    imprintCurves(grid(4), { polyline({ Point3(0, 0, 0), Point3(2, 1, 0) }) }, options);
  EXPECT_EQ(result.status.code, StatusCode::CurveNotOnEdges);
  EXPECT_EQ(result.status.ids, (Indices{ 100, 101 }));
}

TEST(CurveImprint, PointsOffTheSurfaceAreRefusedWithTheirIds)
{
  const auto result = imprintCurves(
    grid(4), { polyline({ Point3(0, 0, 0), Point3(1, 1, 0.5), Point3(9, 9, 0) }) }, {});
  EXPECT_EQ(result.status.code, StatusCode::CurvePointOffSurface);
  EXPECT_EQ(result.status.ids, (Indices{ 101, 102 }));
}

TEST(CurveImprint, ACurveWithoutTwoDifferentPointsIsRefusedWithItsId)
{
  const Polyline good = polyline({ Point3(0, 0, 0), Point3(1, 0, 0) });
  const Polyline bad = polyline({ Point3(1, 1, 0), Point3(1, 1, 0) });
  const auto result = imprintCurves(grid(4), { good, bad }, {});
  EXPECT_EQ(result.status.code, StatusCode::CurveTooShort);
  EXPECT_EQ(result.status.ids, (Indices{ 1 }));
}
