// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutAdjustment.h"

#include "Suggestion/CutThinning.h"
#include "Suggestion/SymmetryPlane.h"
#include "SuggestionTesting.h"
#include "TestThreads.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A sheet with a bump in the middle between its sides, as good as its own image in x = 0.
TriangleMesh oneBump()
{
  return patch(20, 14, [](double i, double j) {
    const double x = i / 10.0 - 1.0;
    const double y = j / 10.0;
    return Point3(x, y, 0.3 * std::exp(-6.0 * (x * x + (y - 0.7) * (y - 0.7))));
  }).mesh;
}

/// A line on a mesh between two of its vertices along which x is the same.
SuggestedCurve upwards(const TriangleMesh& mesh, Index column, Index rows)
{
  SuggestedCurve cut;
  cut.curve.type = CurveType::Dart;
  for (Index j = 0; j <= rows; ++j)
  {
    cut.curve.points.push_back(mesh.point(j * 21 + column));
  }
  cut.length = lengthOf(cut.curve.points);
  return cut;
}

struct Adjusted
{
  CutSet before;
  CutSet after;
};

Adjusted adjusted(const TriangleMesh& mesh, std::vector<SuggestedCurve> cuts,
  const SearchOptions& search, const std::optional<SurfaceMirror>& mirror = {},
  const Execution& execution = {})
{
  const ImprintOptions imprint;
  const FlatteningOptions flattening;
  const RegionWeights weights;
  CutSet set;
  set.cuts = std::move(cuts);
  TrialBudget budget(1e9);
  set.outcome = CutTrials(mesh, {}, imprint, flattening, search.goal, weights)
                  .run(linesOf(set.cuts), budget, {});
  EXPECT_TRUE(set.outcome.valid);
  Adjusted result{ set, set };
  adjustCuts(
    { mesh, {}, imprint, flattening, search, mirror, weights }, 0, result.after, budget, execution);
  return result;
}
}

TEST(CutAdjustment, SlidesADartUnderTheBump)
{
  const TriangleMesh mesh = oneBump();
  SearchOptions search;
  search.bound = 0.0;
  const Adjusted found = adjusted(mesh, { upwards(mesh, 13, 6) }, search);
  const Points3& line = found.after.cuts[0].curve.points;
  EXPECT_LT(found.after.outcome.energy, 0.9 * found.before.outcome.energy);
  EXPECT_NEAR(line.front().y(), 0.0, 1e-9);
  EXPECT_LT(std::abs(line.front().x()), 0.1);
  EXPECT_LT(std::abs(line.back().x()), 0.05);
}

TEST(CutAdjustment, GivesDartsThatAreMirrorImagesTheSameLength)
{
  const TriangleMesh mesh = twoBumps();
  SearchOptions search;
  search.bound = 0.0;
  const Adjusted found = adjusted(mesh, { upwards(mesh, 5, 11), upwards(mesh, 15, 5) }, search);
  const double first = found.after.cuts[0].length;
  const double second = found.after.cuts[1].length;
  EXPECT_LT(found.after.outcome.energy, found.before.outcome.energy);
  EXPECT_LE(found.after.outcome.cutLength(), found.before.outcome.cutLength());
  EXPECT_NEAR(first, lengthOf(found.after.outcome.paths[0]), 1e-9);
  EXPECT_LT(std::abs(first - second), 0.1 * (first + second));
}

TEST(CutAdjustment, KeepsTheBoundAndSpendsLess)
{
  const TriangleMesh mesh = oneBump();
  SearchOptions search;
  search.bound = 1.0;
  const Adjusted uncut = adjusted(mesh, {}, search);
  search.bound = 0.99 * uncut.before.outcome.strainP95;
  const Adjusted found = adjusted(mesh, { upwards(mesh, 9, 8), upwards(mesh, 15, 4) }, search);
  ASSERT_LE(found.before.outcome.strainP95, search.bound);
  EXPECT_LE(found.after.outcome.strainP95, search.bound);
  EXPECT_LT(found.after.outcome.cutLength(), 0.9 * found.before.outcome.cutLength());
  EXPECT_EQ(found.after.end, SearchEnd::BoundMet);
}

TEST(CutAdjustment, MovesPairsAsExactImages)
{
  const TriangleMesh mesh = twoBumps();
  const std::optional<SymmetryPlane> plane = findSymmetryPlane(mesh);
  ASSERT_TRUE(plane.has_value());
  std::vector<SuggestedCurve> cuts{ upwards(mesh, 3, 8), upwards(mesh, 17, 8) };
  cuts[1].mirrorOf = 0;
  SearchOptions search;
  search.bound = 0.0;
  const Adjusted found = adjusted(mesh, cuts, search, SurfaceMirror(*plane));
  EXPECT_LT(found.after.outcome.energy, 0.95 * found.before.outcome.energy);
  const Points3& line = found.after.cuts[0].curve.points;
  const Points3& image = found.after.cuts[1].curve.points;
  ASSERT_EQ(line.size(), image.size());
  for (std::size_t k = 0; k < line.size(); ++k)
  {
    EXPECT_LT((image[k] - Point3(-line[k].x(), line[k].y(), line[k].z())).norm(), 1e-9);
  }
}

TEST(CutAdjustment, IsTheSameForAnyNumberOfThreads)
{
  const TriangleMesh mesh = oneBump();
  SearchOptions search;
  search.bound = 0.0;
  const std::vector<SuggestedCurve> cuts{ upwards(mesh, 13, 6) };
  const Adjusted alone = adjusted(mesh, cuts, search);
  const Adjusted many = adjusted(mesh, cuts, search, {}, withThreads(3));
  EXPECT_EQ(alone.after.cuts[0].curve.points, many.after.cuts[0].curve.points);
  EXPECT_EQ(alone.after.outcome.energy, many.after.outcome.energy);
}
