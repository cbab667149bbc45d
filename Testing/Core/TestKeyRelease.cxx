// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/KeyRelease.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

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

TEST(KeyRelease, OfSeveralSingleCurvesTakesTheOneWithTheLeastObjective)
{
  const Release result = release(
    5, [](const std::set<Index>&) { return true; },
    [](const std::set<Index>& r) { return std::abs(*r.begin() - 2.2); });
  EXPECT_EQ(result.released, (Indices{ 2 }));
}

TEST(KeyRelease, GoesOnToPairsAndThenToAll)
{
  const Release pair = release(
    5, [](const std::set<Index>& r) { return r.count(0) && r.count(4); }, one);
  EXPECT_EQ(pair.released, (Indices{ 0, 4 }));
  const Release all = release(
    5, [](const std::set<Index>& r) { return r.size() == 5; }, one);
  EXPECT_EQ(all.released, (Indices{ 0, 1, 2, 3, 4 }));
}

TEST(KeyRelease, LeavesTheInnocentAloneHoweverManyKeysThereAre)
{
  const Release result = release(
    40,
    [](
      const std::set<Index>& r) { return r.count(3) && r.count(17) && r.count(18) && r.count(39); },
    one);
  EXPECT_EQ(result.released, (Indices{ 3, 17, 18, 39 }));
  EXPECT_LT(result.solves, 100);
  EXPECT_EQ(result.status.message.find("\"key4\""), std::string::npos);
}

TEST(KeyRelease, OfKeysThatClashInPairsReleasesOneOfEachPairWithTheLeastObjective)
{
  const Release result = release(
    20,
    [](const std::set<Index>& r) {
      return (r.count(2) || r.count(11)) && (r.count(5) || r.count(6)) &&
        (r.count(14) || r.count(19));
    },
    [](const std::set<Index>& r) {
      return 10.0 - (r.count(11) ? 1.0 : 0.0) - (r.count(5) ? 2.0 : 0.0) -
        (r.count(19) ? 3.0 : 0.0);
    });
  EXPECT_EQ(result.released, (Indices{ 5, 11, 19 }));
}

TEST(KeyRelease, OneKeyThatClashesWithManyIsReleasedInPlaceOfThem)
{
  const Release result = release(
    20,
    [](const std::set<Index>& r) {
      return r.count(7) || (r.count(1) && r.count(4) && r.count(12) && r.count(16));
    },
    one);
  EXPECT_EQ(result.released, (Indices{ 7 }));
}

TEST(KeyRelease, WhereAlmostAllClashNoneOfTheReleasedCanBeKept)
{
  const Release result = release(
    20, [](const std::set<Index>& r) { return r.size() >= 12; }, one);
  EXPECT_EQ(result.released.size(), 12u);
  EXPECT_LT(result.solves, 200);
}

TEST(KeyRelease, ReleasesNothingWhereNoReleaseHelps)
{
  const Release result = release(
    5, [](const std::set<Index>&) { return false; }, one);
  EXPECT_TRUE(result.released.empty());
  EXPECT_EQ(result.solves, 1);
}
