// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/SurfaceCut.h"
#include "Quality/FlatteningQuality.h"

using namespace flattening;
using namespace testmeshes;

TEST(SurfaceCut, ACurveThatEndsOnADartKeepsToItsSide)
{
  // A girth in two parts, one from each side to the dart.
  const Surface surface = cushion(4, 4, 0.3);
  const std::vector<FeatureCurve> curves{ curveOf(CurveType::Dart, "dart", { 2, 7, 12 }),
    accessory("left", { 5, 6, 7 }), accessory("right", { 7, 8, 9 }) };
  const CutSurface cut = cutSurface(surface.mesh, curves);
  // The copy of vertex 7 in the triangles next to each part.
  const Index left = cut.mesh.to(surface.mesh.find(6, 7));
  const Index right = cut.mesh.from(surface.mesh.find(7, 8));
  EXPECT_NE(left, right);
  EXPECT_NE(cut.mesh.find(cut.mesh.from(surface.mesh.find(6, 7)), left), none);
  for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
  {
    const Triangle& c = cut.mesh.triangle(t);
    const double x =
      (cut.mesh.point(c[0]).x() + cut.mesh.point(c[1]).x() + cut.mesh.point(c[2]).x()) / 3.0;
    EXPECT_TRUE(x < 0.5 || std::count(c.begin(), c.end(), left) == 0);
    EXPECT_TRUE(x > 0.5 || std::count(c.begin(), c.end(), right) == 0);
  }
}

TEST(SurfaceCut, OfCurvesOnOneEdgeTheCutGoesFirst)
{
  const Surface surface = cushion(4, 4, 0.3);
  const Indices chain{ 2, 7, 12 };
  const std::vector<FeatureCurve> curves{ curveOf(CurveType::Accessory, "a", chain),
    curveOf(CurveType::Key, "k", chain), curveOf(CurveType::Dart, "d", chain),
    curveOf(CurveType::Key, "second", { 12, 17 }), curveOf(CurveType::Key, "third", { 12, 17 }) };
  const CutSurface cut = cutSurface(surface.mesh, curves);
  EXPECT_EQ(cut.curveOfHalfedge[surface.mesh.find(2, 7)], 2);
  EXPECT_EQ(cut.curveOfHalfedge[surface.mesh.find(7, 2)], 2);
  EXPECT_EQ(cut.curveOfHalfedge[surface.mesh.find(12, 17)], 3);
}

TEST(CutEnds, AreNamedWithTheVertexThatContinuesThemToTheBoundary)
{
  const auto v = [](Index i, Index j) { return at(6, i, j); };
  const auto seam = [](Indices vertices) { return curveOf(CurveType::Seam, "s", vertices); };
  const auto dart = [](Indices vertices) { return curveOf(CurveType::Dart, "d", vertices); };
  struct Case
  {
    const char* name;
    std::vector<FeatureCurve> curves;
    std::vector<std::array<Index, 3>> ends; ///< curve, its vertex, and that of the boundary
  };
  const std::vector<Case> cases{
    { "a dart", { dart({ v(3, 1), v(3, 2), v(3, 3) }) }, { { 0, v(3, 1), v(3, 0) } } },
    { "a dart that was drawn from its tip",
      { accessory("a", { v(0, 3), v(1, 3) }), dart({ v(3, 3), v(4, 3), v(5, 3) }) },
      { { 1, v(5, 3), v(6, 3) } } },
    { "both ends of a seam", { seam({ v(3, 1), v(3, 2), v(3, 3), v(3, 4), v(3, 5) }) },
      { { 0, v(3, 1), v(3, 0) }, { 0, v(3, 5), v(3, 6) } } },
    { "the nearer end of a dart, whose other is its tip",
      { dart({ v(3, 1), v(3, 2), v(3, 3), v(3, 4), v(3, 5) }) }, { { 0, v(3, 5), v(3, 6) } } },
    { "the tip of a short dart", { dart({ v(3, 0), v(3, 1) }) }, {} },
    { "a dart from a seam", { seam({ v(3, 0), v(3, 1), v(3, 2) }), dart({ v(3, 1), v(2, 1) }) },
      {} },
    { "what cuts nothing", { curveOf(CurveType::Key, "k", { v(3, 1), v(3, 2), v(3, 3) }) }, {} },
    { "a dart far from the boundary", { dart({ v(3, 2), v(3, 3), v(3, 4) }) }, {} },
    { "a closed seam", { seam({ v(1, 1), v(2, 1), v(2, 2), v(1, 2), v(1, 1) }) }, {} },
  };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    const std::vector<ShortEnd> found = endsShortOfBoundary(flatPatch(6, 6).mesh, one.curves);
    ASSERT_EQ(found.size(), one.ends.size());
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      EXPECT_EQ((std::array{ found[k].curve, found[k].vertex, found[k].boundary }), one.ends[k]);
    }
  }
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
