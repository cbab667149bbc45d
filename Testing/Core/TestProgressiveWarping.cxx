// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"
#include "Flattening/PieceWires.h"
#include "Reference/ProgressiveWarping.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
ProgressiveSolution warp(const WiredSurface& wired, AngleMethod method = AngleMethod::Newton)
{
  AngleSolverOptions options;
  options.method = method;
  return warpProgressively(wired.problem(), options, {});
}

/// With the repair of what does not close.
PieceSolution warpAndRepair(const WiredSurface& wired)
{
  const Execution execution;
  return solveWires({ wired.piece, wired.network, wired.cut, wired.curves,
                      withScheme(Scheme::Progressive), execution },
    {});
}

double worstConstraint(const AngleProblem& problem, const std::vector<double>& theta)
{
  return AngleConstraints(problem).residual(theta).cwiseAbs().maxCoeff();
}

/// Four wire-patches in a row from y = 0 up.
Surface fourBands()
{
  Surface surface = cushion(4, 8, 0.2);
  surface.curves = { rowCurve(4, 2), rowCurve(4, 4), rowCurve(4, 6) };
  return surface;
}
}

TEST(ProgressiveWarping, StartsAtKeysAndGoesOnToTheLargestEvidence)
{
  // 12 nodes a patch. The key locks 5 of patches 2 and 3; patch 2 then gives 3 nodes to patch 1,
  // which is fewer than the 5 of patch 3.
  Surface surface = fourBands();
  surface.curves[2].type = CurveType::Key;
  const ProgressiveSolution solution = warp(WiredSurface(surface));
  ASSERT_TRUE(solution.angles.status.ok());
  EXPECT_EQ(solution.warpingOrder, (Indices{ 2, 3, 1, 0 }));
}

TEST(ProgressiveWarping, WithoutKeysStartsAtTheFirstPatchAndWalksToItsNeighbours)
{
  EXPECT_EQ(warp(WiredSurface(fourBands())).warpingOrder, (Indices{ 0, 1, 2, 3 }));
  // A cross: the patches beside the first one know three nodes each, the one across none.
  Surface cross = cushion(4, 4, 0.2);
  cross.curves = { rowCurve(4, 2), columnCurve(4, 4, 2) };
  const ProgressiveSolution solution = warp(WiredSurface(cross));
  EXPECT_EQ(solution.warpingOrder, (Indices{ 0, 1, 2, 3 }));
}

TEST(ProgressiveWarping, TheFirstPatchIsFlattenedAsIfItWereAlone)
{
  Surface surface = quarterSphere();
  const WiredSurface whole(surface);
  const ProgressiveSolution solution = warp(whole);
  EXPECT_TRUE(solution.closes());
  surface.curves[0].type = CurveType::Seam;
  const WiredSurface alone(surface); // the first of its two pieces
  const AngleSolution single = alone.solve();
  ASSERT_EQ(alone.network.nodeCount(), whole.network.loopBegin[1]);
  for (Index i = 0; i < alone.network.nodeCount(); ++i)
  {
    const Index vertex = alone.original(alone.network.vertex[i]);
    for (Index k = 0; k < whole.network.loopBegin[1]; ++k)
    {
      if (whole.original(whole.network.vertex[k]) == vertex)
      {
        EXPECT_NEAR(solution.angles.theta[k], single.theta[i], 1e-10);
      }
    }
  }
}

TEST(ProgressiveWarping, AnglesAroundInnerVerticesSumToAWholeTurn)
{
  const WiredSurface wired(quarterSphere());
  const AngleProblem problem = wired.problem();
  for (const AngleMethod method : { AngleMethod::Newton, AngleMethod::Sequential })
  {
    const ProgressiveSolution solution = warp(wired, method);
    ASSERT_TRUE(solution.angles.status.ok());
    EXPECT_LT(worstConstraint(problem, solution.angles.theta), 1e-11);
    EXPECT_GT(solution.angles.objective, 0.197157) << "the global optimum is below";
  }
}

TEST(ProgressiveWarping, OfASinglePatchIsTheGlobalOptimum)
{
  Surface plain = cushion(8, 6, 0.4);
  Surface dart = plain;
  dart.curves = { curveOf(CurveType::Dart, "dart", { 4, 13, 22 }) };
  Surface dangling = plain;
  dangling.curves = { accessory("dangling", { 4, 13, 22, 31 }) };
  for (const Surface& surface : { plain, dart, dangling })
  {
    const WiredSurface wired(surface);
    ASSERT_EQ(wired.network.loopCount(), 1);
    const ProgressiveSolution solution = warp(wired);
    ASSERT_TRUE(solution.angles.status.ok());
    EXPECT_LT(largestDifference(solution.angles.theta, wired.solve().theta), 1e-9);
  }
}

TEST(ProgressiveWarping, WiresMeetAlsoWhereTheLastPatchesHaveNoFreeAngle)
{
  // A grid of wires on a strongly curved surface: patches in the middle inherit all their angles.
  Surface surface = cushion(6, 6, 0.4);
  for (Index k = 1; k < 6; ++k)
  {
    surface.curves.push_back(rowCurve(6, k));
    surface.curves.push_back(columnCurve(6, 6, k));
  }
  const WiredSurface wired(surface);
  const AngleProblem problem = wired.problem();
  const ProgressiveSolution progressive = warp(wired);
  EXPECT_FALSE(progressive.closes());
  EXPECT_STREQ(statusName(progressive.angles.status.code), "NotConverged");
  EXPECT_EQ(progressive.warpingOrder.size(), 36U);
  const PieceSolution solution = warpAndRepair(wired);
  EXPECT_TRUE(solution.report.repaired);
  ASSERT_TRUE(solution.angles.status.ok()) << solution.angles.status.message;
  EXPECT_EQ(solution.report.warpingOrder.size(), 36U);
  EXPECT_LT(solution.angles.closure, 1e-12 * perimeter(problem));
  EXPECT_LT(worstConstraint(problem, solution.angles.theta), 1e-11);
}
