// SPDX-License-Identifier: BSD-3-Clause
// How a run that is refused or told to stop ends, and what it tells on its way.
#include "ClosedMeshes.h"
#include "Flattened.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
void expectEmpty(const FlatteningResult& result)
{
  EXPECT_TRUE(result.status.refused());
  EXPECT_FALSE(result.status.message.empty());
  EXPECT_EQ(result.cut->mesh.vertexCount(), 0);
  EXPECT_TRUE(result.positions.empty());
  EXPECT_TRUE(result.triangles.empty());
  EXPECT_TRUE(result.wires.empty());
  EXPECT_TRUE(result.pieces.empty());
  EXPECT_TRUE(result.curves.empty());
}
}

TEST(FlatteningEnds, ARefusedSurfaceLeavesNothing)
{
  const Surface surface = cushion(4, 4, 0.2);
  expectEmpty(flattenSurface(surface.mesh, { accessory("c", { 0, 24 }) }, {}, {}));
  const FlatteningResult closed = flattenSurface(sphere(0), {}, {}, {});
  EXPECT_STREQ(statusName(closed.status.code), "ClosedSurface");
  expectEmpty(closed);
}

TEST(FlatteningEnds, AMeshWithoutTrianglesIsRefused)
{
  const FlatteningResult result = flattenSurface(TriangleMesh(), {}, {}, {});
  EXPECT_STREQ(statusName(result.status.code), "EmptySurface");
  expectEmpty(result);
}

TEST(FlatteningEnds, APlanarShapeOfAnotherNumberOfPointsOrWithoutAnAngleIsRefused)
{
  Surface surface = cushion(4, 4, 0.2);
  surface.curves = { curveOf(CurveType::Key, "k", { 10, 11, 12, 13, 14 }) };
  surface.curves[0].keyShape = KeyShape::Planar;
  for (const Points2& shape :
    { Points2{ { 0, 0 }, { 1, 0 } }, Points2{ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 0 }, { 3, 1 } } })
  {
    surface.curves[0].planarShape = shape;
    const FlatteningResult result = flatten(surface, {});
    EXPECT_STREQ(statusName(result.status.code), "InvalidCurve");
    expectEmpty(result);
  }
}

TEST(FlatteningEnds, ToldToStopItLeavesNothingWheneverThatIs)
{
  Surface surface = cushion(6, 6, 0.3);
  surface.curves = { rowCurve(6, 3), curveOf(CurveType::Dart, "dart", { 2, 9, 16 }) };
  for (const Scheme scheme : { Scheme::Global, Scheme::Progressive, Scheme::Isometric })
  {
    const FlatteningOptions options = optionsOf(scheme, InteriorMethod::AsRigidAsPossible);
    int asked = 0;
    Execution execution;
    execution.cancel = [&asked] {
      ++asked;
      return false;
    };
    const FlatteningResult whole = flatten(surface, options, execution);
    ASSERT_FALSE(whole.status.refused());
    const int all = asked;
    ASSERT_GT(all, 5);
    for (int stop = 0; stop < all; stop += 1 + all / 20)
    {
      asked = 0;
      execution.cancel = [&asked, stop] { return asked++ >= stop; };
      const FlatteningResult result = flatten(surface, options, execution);
      EXPECT_STREQ(statusName(result.status.code), "Cancelled") << stop << " of " << all;
      expectEmpty(result);
    }
  }
}

TEST(FlatteningEnds, ReportsProgressInOrder)
{
  Surface surface = cushion(9, 6, 0.2);
  surface.curves = { columnCurve(9, 6, 4, CurveType::Seam) };
  std::vector<double> fractions;
  Execution execution;
  execution.progress = [&fractions](double fraction, const char* phase) {
    EXPECT_NE(std::string(phase), "");
    fractions.push_back(fraction);
  };
  flatten(surface, {}, execution);
  ASSERT_GE(fractions.size(), 3U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_DOUBLE_EQ(fractions.front(), 0.0);
  EXPECT_DOUBLE_EQ(fractions.back(), 1.0);
}
