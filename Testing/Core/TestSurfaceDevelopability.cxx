// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"
#include "Quality/FlatteningQuality.h"

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
