// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/SurfaceDevelopability.h"

#include "Flattened.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

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

TEST(CutLength, ADartCountsOnceThoughItHasTwoBanks)
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
