// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"
#include "Quality/FlatteningQuality.h"
#include "TestMeshes.h"

using namespace flattening;
using namespace testmeshes;

TEST(FlatteningQuality, TheDistortionAloneIsThatOfAllMeasures)
{
  const Surface surface = cushion(8, 6, 0.3);
  Points2 stretched;
  for (const Point3& p : surface.mesh.points())
  {
    stretched.emplace_back(1.1 * p.x() + 0.1 * p.y() * p.y(), 0.9 * p.y());
  }
  Points2 folded = stretched;
  folded[20].x() += 3.0;
  Points2 mirrored = stretched;
  for (Point2& p : mirrored)
  {
    p.x() = -p.x();
  }
  const Points2 collapsed(stretched.size(), Point2(1.0, 2.0));
  for (const Points2& positions : { stretched, folded, mirrored, collapsed })
  {
    const QualitySummary all = measureFlattening(surface.mesh, positions, {}, {}).summary;
    const MapDistortion alone = measureDistortion(surface.mesh, positions, withThreads(3));
    EXPECT_EQ(alone.globalHomogeneity, all.globalHomogeneity);
    EXPECT_EQ(alone.rigidEnergy, all.rigidEnergy);
  }
}

TEST(CutLength, ASeamBoundsBothPiecesADartHasTwoSidesAndEachCountsOnce)
{
  Surface surface = unitSquares(4, 4);
  // A seam along the boundary and a curve inside cut nothing.
  surface.curves = { columnCurve(4, 4, 1, CurveType::Seam),
    curveOf(CurveType::Dart, "dart", { 3, 8 }), rowCurve(4, 0, CurveType::Seam), rowCurve(4, 2) };
  const FlatteningResult result = flattenOk(surface);
  ASSERT_EQ(result.pieces.size(), 2U);
  EXPECT_EQ(result.pieces[0].cutLength, 4.0);
  EXPECT_EQ(result.pieces[1].cutLength, 5.0);
  // Both together are cut open once along each.
  EXPECT_EQ(cutLength(cutSurface(surface.mesh, surface.curves).mesh), 5.0);
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
