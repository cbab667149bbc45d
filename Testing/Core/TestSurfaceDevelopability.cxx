// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"
#include "Quality/FlatteningQuality.h"
#include "TestMeshes.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace flattening;
using namespace testmeshes;

namespace
{
std::vector<double> developability(const TriangleMesh& mesh)
{
  return surfaceDevelopability(mesh, cornerAngles(mesh, {}));
}
}

TEST(SurfaceDevelopability, IsZeroOnDevelopableSurfaces)
{
  for (const Surface& surface : { flatPatch(7, 5), cone(9, 6), cylinder(8, 5) })
  {
    for (double value : developability(surface.mesh))
    {
      EXPECT_LT(value, 1e-13);
    }
  }
}

TEST(SurfaceDevelopability, SumsToWhatGaussAndBonnetSayOfAConvexSurface)
{
  const TriangleMesh mesh = quarterSphere().mesh;
  const std::vector<double> values = developability(mesh);
  double turning = 0.0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.onBoundary(v))
    {
      EXPECT_EQ(values[v], 0.0);
      double sum = 0.0;
      for (Index h = mesh.outgoing(v); h != none; h = mesh.counterClockwise(h))
      {
        sum += mesh.angle(h);
      }
      turning += pi - sum;
    }
  }
  EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0) + turning, 2.0 * pi, 1e-13);
}

TEST(SurfaceDevelopability, MeasuresASaddleAsMuchAsAPeak)
{
  // Six triangles around a vertex whose neighbours alternate above and below.
  Points3 points{ Point3::Zero() };
  Triangles triangles;
  for (Index k = 0; k < 6; ++k)
  {
    points.push_back(
      Point3(std::cos(k * pi / 3.0), std::sin(k * pi / 3.0), k % 2 == 0 ? 0.5 : -0.5));
    triangles.push_back({ 0, 1 + k, 1 + (k + 1) % 6 });
  }
  const double expected = 6.0 * std::acos((0.5 - 0.25) / 1.25) - 2.0 * pi;
  ASSERT_GT(expected, 1.0);
  EXPECT_NEAR(developability(TriangleMesh(points, triangles))[0], expected, 1e-14);
}

namespace
{
/// The unit grid of the given size, flat, with curves.
Surface grid(Index columns, Index rows, std::vector<FeatureCurve> curves)
{
  Surface surface = patch(
    columns, rows, [](double i, double j) -> Point3 { return Point3(i, j, 0.0); },
    [](double i, double j) { return Point2(i, j); });
  surface.curves = std::move(curves);
  return surface;
}

std::vector<double> cutLengthsOf(const Surface& surface)
{
  const FlatteningResult result = flatten(surface);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  std::vector<double> lengths;
  for (const PieceReport& piece : result.pieces)
  {
    lengths.push_back(piece.cutLength);
  }
  return lengths;
}
}

TEST(CutLength, ASurfaceThatNothingCutsHasNone)
{
  EXPECT_EQ(cutLength(flatPatch(4, 3).mesh), 0.0);
  Surface surface = grid(4, 4, { rowCurve(4, 2) });
  EXPECT_EQ(cutLengthsOf(surface), std::vector<double>{ 0.0 });
}

TEST(CutLength, ADartCountsOnceThoughItHasTwoSides)
{
  // From (2, 0) to (2, 3) in a grid of 5 points a row.
  const Surface surface = grid(4, 4, { curveOf(CurveType::Dart, "dart", { 2, 7, 12, 17 }) });
  EXPECT_EQ(cutLength(cutSurface(surface.mesh, surface.curves).mesh), 3.0);
  EXPECT_EQ(cutLengthsOf(surface), std::vector<double>{ 3.0 });
}

TEST(CutLength, ASeamBoundsBothPiecesAndCountsOnceInEach)
{
  const Surface surface = grid(4, 4,
    { curveOf(CurveType::Seam, "seam", { 1, 6, 11, 16, 21 }),
      curveOf(CurveType::Dart, "dart", { 3, 8 }) });
  EXPECT_EQ(cutLengthsOf(surface), (std::vector<double>{ 4.0, 5.0 }));
  // Both together are cut open once along each.
  EXPECT_EQ(cutLength(cutSurface(surface.mesh, surface.curves).mesh), 5.0);
}

TEST(CutLength, EdgesOfTheBoundaryThatLieOnNoOtherAreNotCut)
{
  // A seam along the boundary cuts nothing.
  const Surface surface = grid(4, 4, { curveOf(CurveType::Seam, "hem", { 0, 1, 2, 3, 4 }) });
  EXPECT_EQ(cutLengthsOf(surface), std::vector<double>{ 0.0 });
}

TEST(CutLength, WhereThreeSheetsMeetTheLineCountsOnce)
{
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  for (const Point3& apex : { Point3(0, 1, 0), Point3(0, -1, 0), Point3(0, 0, 1) })
  {
    const Index first = static_cast<Index>(points.size());
    // Zeros of either sign are one place.
    points.insert(points.end(), { Point3(-0.0, 0, 0), Point3(2, 0, first > 0 ? -0.0 : 0.0), apex });
    triangles.push_back({ first, first + 1, first + 2 });
  }
  EXPECT_EQ(cutLength(TriangleMesh(points, triangles)), 2.0);
}
