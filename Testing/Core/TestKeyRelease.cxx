// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/AngleSolver.h"
#include "Angles/KeyRelease.h"
#include "Angles/ReleaseAdvice.h"
#include "Flattened.h"

#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
struct Release
{
  Indices released;
  Status status;
  int solves = 0;
};

/// Key curves "key0", "key1", ... and what the search makes of a solver that succeeds where `works`
/// says so of the released ones, with the objective that `cost` gives.
template <class Works, class Cost>
Release release(Index count, Works works, Cost cost)
{
  std::vector<FeatureCurve> curves;
  Indices keys;
  for (Index k = 0; k < count; ++k)
  {
    curves.push_back(curveOf(CurveType::Key, "key" + std::to_string(k), { k, k + 1 }));
    keys.push_back(k);
  }
  Release result;
  std::set<Indices> asked;
  const KeyRelease found = releaseKeys(keys, [&](const Indices& next) -> std::optional<double> {
    EXPECT_TRUE(asked.insert(next).second) << "solved the same trial twice";
    const std::set<Index> released(next.begin(), next.end());
    ++result.solves;
    return works(released) ? std::optional<double>(cost(released)) : std::nullopt;
  });
  result.released = found.released;
  result.status = describeRelease(curves, keys, found);
  return result;
}

double one(const std::set<Index>&)
{
  return 1.0;
}
}

TEST(KeyRelease, ReleasesOneCurveWhereOneIsEnough)
{
  const Release result = release(
    5, [](const std::set<Index>& r) { return r.count(3) > 0; }, one);
  EXPECT_EQ(result.released, (Indices{ 3 }));
  EXPECT_STREQ(statusName(result.status.code), "IncompatibleKeys");
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::Curves, Indices{ 3 } }));
  ASSERT_FALSE(result.status.remedies.empty());
  EXPECT_EQ(result.status.remedies.front().remedy, Remedy::MakeAccessory);
  EXPECT_EQ(result.status.remedies.front().subject, "\"key3\"");
}

TEST(KeyRelease, ReleasesTheFewestAndOfAsManyThoseOfTheLeastObjective)
{
  using Keys = std::set<Index>;
  struct Case
  {
    Index count;
    std::function<bool(const Keys&)> works;
    std::function<double(const Keys&)> cost;
    Indices released;
    int solves = 1000000;
  };
  const std::vector<Case> cases{
    { 5, [](const Keys&) { return true; }, [](const Keys& r) { return std::abs(*r.begin() - 2.2); },
      { 2 } },
    { 5, [](const Keys& r) { return r.count(0) && r.count(4); }, one, { 0, 4 } },
    { 5, [](const Keys& r) { return r.size() == 5; }, one, { 0, 1, 2, 3, 4 } },
    { 5, [](const Keys&) { return false; }, one, {} },
    // One of each of three pairs that clash.
    { 20,
      [](const Keys& r) {
        return (r.count(2) || r.count(11)) && (r.count(5) || r.count(6)) &&
          (r.count(14) || r.count(19));
      },
      [](const Keys& r) {
        return 10.0 - (r.count(11) ? 1.0 : 0.0) - (r.count(5) ? 2.0 : 0.0) -
          (r.count(19) ? 3.0 : 0.0);
      },
      { 5, 11, 19 } },
    // The innocent are left alone however many there are.
    { 40, [](const Keys& r) { return r.count(3) && r.count(17) && r.count(18) && r.count(39); },
      one, { 3, 17, 18, 39 }, 100 },
    // One that clashes with four others.
    { 20,
      [](const Keys& r) {
        return r.count(7) || (r.count(1) && r.count(4) && r.count(12) && r.count(16));
      },
      one, { 7 } },
  };
  for (const Case& c : cases)
  {
    const Release result = release(c.count, c.works, c.cost);
    EXPECT_EQ(result.released, c.released);
    EXPECT_LT(result.solves, c.solves);
  }
}

TEST(KeyRelease, WhereAlmostAllClashNoneOfTheReleasedCanBeKept)
{
  const Release result = release(
    20, [](const std::set<Index>& r) { return r.size() >= 12; }, one);
  EXPECT_EQ(result.released.size(), 12u);
  EXPECT_LT(result.solves, 200);
}

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

TEST(ReleaseAdvice, IsSilentWhereTheSolutionIsGood)
{
  const Surface surface = quarterSphere();
  const FlatteningResult result = flatten(surface);
  EXPECT_FALSE(result.pieces[0].advice.first().solved);
}
