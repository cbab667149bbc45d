// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"

using namespace flattening;
using namespace testmeshes;

TEST(SurfaceFlattening, OnTheTwoArcsOfFigure14ThePapersIterationFailsAndNewtonFindsTheBetterMinimum)
{
  FlatteningOptions options = optionsOf(Scheme::Global);
  const FlatteningResult newton = flatten(quarterSphereWithTwoArcs(), options);
  ASSERT_EQ(newton.pieces.size(), 1U);
  EXPECT_NEAR(newton.pieces.front().objective, 3.14777, 5e-6);
  EXPECT_LT(newton.pieces.front().quality.maximumEdgeLengthError, 1e-10);
  options.angles.method = AngleMethod::Sequential;
  const FlatteningResult sequential = flatten(quarterSphereWithTwoArcs(), options);
  // How far it strays depends on how SuperLU's BLAS rounds.
  EXPECT_TRUE(sequential.status.code == StatusCode::LengthError ||
    sequential.status.code == StatusCode::NotConverged)
    << statusName(sequential.status.code);
}

TEST(SurfaceFlattening, DevelopablesUnrollToTheirExactShape)
{
  Surface tube = withCurves(
    cylinder(9, 6), { rowCurve(9, 2), columnCurve(9, 6, 4), accessory("dangling", { 7, 17 }) });
  Surface horn = withCurves(cone(10, 6),
    { columnCurve(10, 6, 3), curveOf(CurveType::Key, "key", rowCurve(10, 3).vertices),
      curveOf(CurveType::Dart, "dart", { 5, 16, 27 }) });
  for (const Surface& surface : { tube, horn })
  {
    for (const Scheme scheme : { Scheme::Global, Scheme::Progressive, Scheme::Isometric })
    {
      const FlatteningResult result =
        flattenOk(surface, optionsOf(scheme, InteriorMethod::AsRigidAsPossible));
      EXPECT_LT(worstPiece(surface, result), 1e-10);
      EXPECT_LT(result.pieces.front().objective, 1e-20);
      EXPECT_NEAR(result.pieces.front().quality.globalHomogeneity, 1.0, 1e-9);
    }
  }
}

TEST(SurfaceFlattening, NamesKeysThatCannotKeepTheirShapesAndGoesOnWithoutTheLeastSet)
{
  // What Eq. 1 gives for the ring cannot close around the curved region in it; the row is innocent.
  Surface surface = withCurves(cushion(8, 8, 0.2),
    { curveOf(CurveType::Key, "ring", { 30, 31, 32, 41, 50, 49, 48, 39, 30 }), columnCurve(8, 8, 4),
      curveOf(CurveType::Key, "hem", rowCurve(8, 1).vertices) });
  for (const Scheme scheme : { Scheme::Global, Scheme::Progressive })
  {
    const FlatteningResult result = flatten(surface, optionsOf(scheme));
    EXPECT_STREQ(statusName(result.status.code), "IncompatibleKeys");
    EXPECT_FALSE(result.status.refused());
    EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::Curves, Indices{ 0 } }))
      << result.status.message;
    EXPECT_NE(result.status.message.find("\"ring\""), std::string::npos);
    EXPECT_NE(result.status.message.find("\"hem\""), std::string::npos);
    EXPECT_LT(result.pieces.front().quality.maximumEdgeLengthError, 1e-12);
    // The same as if the ring had been given as an accessory curve.
    Surface suggested = surface;
    suggested.curves[0].type = CurveType::Accessory;
    const FlatteningResult expected = flatten(suggested, optionsOf(scheme));
    ASSERT_FALSE(expected.status.refused());
    EXPECT_LT(rigidDistance(result.positions, expected.positions), 1e-10);
    EXPECT_EQ(result.pieces.front().warpingOrder, expected.pieces.front().warpingOrder);
  }
}

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

TEST(FlatteningEnds, APlanarShapeOfAnotherNumberOfPointsOrWithoutAnAngleIsRefused)
{
  Surface surface =
    withCurves(cushion(4, 4, 0.2), { curveOf(CurveType::Key, "k", { 10, 11, 12, 13, 14 }) });
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
  Surface surface = withCurves(
    cushion(6, 6, 0.3), { rowCurve(6, 3), curveOf(CurveType::Dart, "dart", { 2, 9, 16 }) });
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
