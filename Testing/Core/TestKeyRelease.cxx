// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/KeyRelease.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Key curves, rows of a patch; which of them are locked can be read from locks.
WiredSurface rowsOfKeys(Index count)
{
  Surface surface = cushion(4, count + 1, 0.2);
  for (Index j = 1; j <= count; ++j)
  {
    surface.curves.push_back(
      curveOf(CurveType::Key, "key" + std::to_string(j - 1), rowCurve(4, j).vertices));
  }
  return WiredSurface(surface);
}

WiredSurface fiveKeys()
{
  return rowsOfKeys(5);
}

std::set<Index> releasedIn(const WiredSurface& wired, const NodeLocks& locks)
{
  std::set<Index> released;
  for (const WireEdge& edge : wired.network.edges)
  {
    if (edge.curve != none && !locks.locked[edge.side])
    {
      released.insert(edge.curve);
    }
  }
  return released;
}

AngleSolution failure(StatusCode code = StatusCode::NotConverged)
{
  AngleSolution solution;
  solution.status = { code, "failed", {} };
  return solution;
}

/// A solver that succeeds where `works` says so, with the objective that `cost` gives.
template <class Works, class Cost>
KeyRelease release(const WiredSurface& wired, Works works, Cost cost)
{
  return releaseKeys(
    wired.network, wired.piece, wired.cut, wired.curves, failure(), [&](const NodeLocks& locks) {
      const std::set<Index> released = releasedIn(wired, locks);
      AngleSolution solution = works(released) ? AngleSolution() : failure();
      solution.objective = cost(released);
      return solution;
    });
}
}

TEST(KeyRelease, ReleasesOneCurveWhereOneIsEnough)
{
  const WiredSurface wired = fiveKeys();
  const KeyRelease result = release(
    wired, [](const std::set<Index>& r) { return r.count(3) > 0; },
    [](const std::set<Index>&) { return 1.0; });
  EXPECT_EQ(result.released, (Indices{ 3 }));
  EXPECT_TRUE(result.solution.status.ok());
  EXPECT_STREQ(statusName(result.status.code), "IncompatibleKeys");
  EXPECT_EQ(result.status.ids, (Indices{ 3 }));
  EXPECT_NE(result.status.message.find("release \"key3\""), std::string::npos);
  EXPECT_EQ(releasedIn(wired, result.locks), (std::set<Index>{ 3 }));
}

TEST(KeyRelease, OfSeveralSingleCurvesTakesTheOneWithTheLeastObjective)
{
  const KeyRelease result = release(
    fiveKeys(), [](const std::set<Index>&) { return true; },
    [](const std::set<Index>& r) { return std::abs(*r.begin() - 2.2); });
  EXPECT_EQ(result.released, (Indices{ 2 }));
}

TEST(KeyRelease, GoesOnToPairsAndThenToAll)
{
  const auto flat = [](const std::set<Index>&) { return 1.0; };
  const KeyRelease pair = release(
    fiveKeys(), [](const std::set<Index>& r) { return r.count(0) && r.count(4); }, flat);
  EXPECT_EQ(pair.released, (Indices{ 0, 4 }));
  const KeyRelease all = release(
    fiveKeys(), [](const std::set<Index>& r) { return r.size() == 5; }, flat);
  EXPECT_EQ(all.released, (Indices{ 0, 1, 2, 3, 4 }));
}

TEST(KeyRelease, LeavesTheInnocentAloneHoweverManyKeysThereAre)
{
  int solves = 0;
  const KeyRelease result = release(
    rowsOfKeys(40),
    [&solves](const std::set<Index>& r) {
      ++solves;
      return r.count(3) && r.count(17) && r.count(18) && r.count(39);
    },
    [](const std::set<Index>&) { return 1.0; });
  EXPECT_EQ(result.released, (Indices{ 3, 17, 18, 39 }));
  EXPECT_LT(solves, 100);
  EXPECT_EQ(result.status.message.find("\"key4\""), std::string::npos);
}

TEST(KeyRelease, OfKeysThatClashInPairsReleasesOneOfEachPairWithTheLeastObjective)
{
  const KeyRelease result = release(
    rowsOfKeys(20),
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
  const KeyRelease result = release(
    rowsOfKeys(20),
    [](const std::set<Index>& r) {
      return r.count(7) || (r.count(1) && r.count(4) && r.count(12) && r.count(16));
    },
    [](const std::set<Index>&) { return 1.0; });
  EXPECT_EQ(result.released, (Indices{ 7 }));
}

TEST(KeyRelease, WhereAlmostAllClashNoneOfTheReleasedCanBeKept)
{
  int solves = 0;
  const auto works = [&solves](const std::set<Index>& r) {
    ++solves;
    return r.size() >= 12;
  };
  const KeyRelease result =
    release(rowsOfKeys(20), works, [](const std::set<Index>&) { return 1.0; });
  EXPECT_EQ(result.released.size(), 12u);
  EXPECT_TRUE(result.solution.status.ok());
  EXPECT_LT(solves, 200);
}

TEST(KeyRelease, KeepsTheFailureWhereNoReleaseHelps)
{
  const KeyRelease result = release(
    fiveKeys(), [](const std::set<Index>&) { return false; },
    [](const std::set<Index>&) { return 1.0; });
  EXPECT_TRUE(result.released.empty());
  EXPECT_STREQ(statusName(result.status.code), "NotConverged");
}

TEST(KeyRelease, StopsWhenTheSolverIsCancelled)
{
  const WiredSurface wired = fiveKeys();
  int solves = 0;
  const KeyRelease result = releaseKeys(
    wired.network, wired.piece, wired.cut, wired.curves, failure(), [&solves](const NodeLocks&) {
      ++solves;
      return failure(StatusCode::Cancelled);
    });
  EXPECT_EQ(solves, 1);
  EXPECT_STREQ(statusName(result.status.code), "Cancelled");
}
