// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/AngleSolver.h"
#include "Angles/ReleaseAdvice.h"
#include "Flattened.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

TEST(ReleaseAdvice, SensitivityIsTheChangeOfTheOptimumWhenACurveGrows)
{
  Surface surface = cushion(6, 8, 0.3);
  surface.curves = { columnCurve(6, 8, 3), rowCurve(6, 4) };
  const WiredSurface wired(surface);
  const ReleaseAdvice advice = adviseRelease(wired.network, wired.curves, wired.solve());
  for (Index curve = 0; curve < 2; ++curve)
  {
    const auto optimum = [&](double factor) {
      AngleProblem problem = wired.problem();
      for (Index e = 0; e < wired.network.edgeCount(); ++e)
      {
        if (wired.network.edges[e].curve == curve)
        {
          problem.length[e] *= factor;
        }
      }
      return solveAnglesByNewton(problem, {}, {}).objective;
    };
    const double step = 1e-5;
    const double slope = (optimum(1.0 + step) - optimum(1.0 - step)) / (2.0 * step);
    EXPECT_NEAR(advice.sensitivity[curve], slope, 1e-4 * (1.0 + std::abs(slope)));
  }
}

TEST(ReleaseAdvice, OnTheQuarterSphereWithTwoArcsReleasingTheFirstGivesThePapersObjective)
{
  const Surface surface = quarterSphereWithTwoArcs();
  const FlatteningResult result = flatten(surface, withScheme(Scheme::Global));
  const ReleaseAdvice& advice = result.pieces[0].advice;
  ASSERT_EQ(advice.ranking.size(), 2u);
  // The long arc costs more; without it the piece is that of Fig. 11.
  EXPECT_EQ(advice.ranking[0], 1);
  EXPECT_NEAR(advice.first().objective, 0.197157, 1e-6);
}

TEST(ReleaseAdvice, WithTheDefaultsTellsWhatFlatteningWithoutTheCurveGives)
{
  Surface surface = quarterSphereWithTwoArcs();
  const FlatteningResult both = flatten(surface);
  const ReleaseAdvice& advice = both.pieces[0].advice;
  ASSERT_TRUE(advice.first().solved);
  surface.curves.erase(surface.curves.begin() + advice.ranking[0]);
  const FlatteningResult without = flatten(surface);
  ASSERT_TRUE(without.status.ok());
  EXPECT_NEAR(advice.first().objective, without.pieces[0].objective, 1e-9);
}

TEST(ReleaseAdvice, IsSilentWhereTheSolutionIsGood)
{
  const Surface surface = quarterSphere();
  const FlatteningResult result = flatten(surface);
  EXPECT_FALSE(result.pieces[0].advice.first().solved);
}
