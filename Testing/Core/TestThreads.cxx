// SPDX-License-Identifier: BSD-3-Clause
// Several pieces and wire-patches on several threads. Built with -fsanitize=thread it also shows
// that the threads do not race (see Testing/Fuzz/README.md).
#include "Base/ThreadedLoop.h"
#include "Design/KeyPrices.h"
#include "Design/LineSuggestion.h"
#include "Flattened.h"
#include "Reshaping/FlattenableSurface.h"
#include "Sewing/PieceSewing.h"
#include "Suggestion/CurveSuggestion.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <thread>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Loops run on four other threads; counts what the caller hears on a thread that is not its own.
struct Caller
{
  std::thread::id thread = std::this_thread::get_id();
  std::atomic<int> asked{ 0 };
  std::atomic<int> elsewhere{ 0 };

  Execution execution()
  {
    Execution run = withThreads(4);
    run.cancel = [this] {
      this->hear();
      return false;
    };
    run.progress = [this](double, const char*) { this->hear(); };
    return run;
  }

private:
  void hear()
  {
    ++this->asked;
    this->elsewhere += std::this_thread::get_id() != this->thread ? 1 : 0;
  }
};
}

TEST(Threads, GiveEverySchemeTheSameResultBitByBit)
{
  constexpr Index size = 12;
  Surface surface = withCurves(cushion(size, size, 0.3),
    { columnCurve(size, size, 4, CurveType::Seam), rowCurve(size, 4), rowCurve(size, 8),
      columnCurve(size, size, 8) });
  for (const Scheme scheme :
    { Scheme::Progressive, Scheme::Global, Scheme::Isometric, Scheme::LeastSquaresConformal })
  {
    for (const InteriorMethod interior :
      { InteriorMethod::Laplacian, InteriorMethod::Relaxation, InteriorMethod::AsRigidAsPossible })
    {
      const FlatteningOptions options = optionsOf(scheme, interior);
      const FlatteningResult alone = flatten(surface, options);
      const FlatteningResult shared = flatten(surface, options, withThreads(4));
      ASSERT_FALSE(alone.status.refused()) << alone.status.message;
      ASSERT_EQ(alone.pieces.size(), 2U);
      EXPECT_EQ(alone.status.message, shared.status.message);
      EXPECT_EQ(alone.positions, shared.positions);
      EXPECT_EQ(alone.developability, shared.developability);
      for (std::size_t p = 0; p < 2; ++p)
      {
        EXPECT_EQ(alone.pieces[p].quality.areaError, shared.pieces[p].quality.areaError);
      }
    }
  }
}

TEST(Threads, HearTheCallerOnItsOwnThreadOnly)
{
  constexpr Index size = 12;
  const Surface plain = cushion(size, size, 0.3);
  const std::vector<FeatureCurve> keys{ rowCurve(size, 4, CurveType::Key),
    rowCurve(size, 8, CurveType::Key) };
  const FeatureCurve seam = columnCurve(size, size, 4, CurveType::Seam);
  const FlatteningResult pieces = flattenSurface(plain.mesh, { seam }, {}, {});
  ASSERT_FALSE(pieces.status.refused()) << pieces.status.message;
  SuggestionOptions darts;
  darts.search.maximumCuts = 2;
  darts.search.trials = 8;
  const std::map<std::string, std::function<Status(const Execution&)>> runs = {
    { "flattening",
      [&](const Execution& run) { return flattenSurface(plain.mesh, { seam }, {}, run).status; } },
    { "key prices",
      [&](const Execution& run) { return priceKeys(plain.mesh, keys, {}, run).status; } },
    { "darts",
      [&](const Execution& run) { return suggestCurves(plain.mesh, {}, darts, run).status; } },
    { "lines", [&](const Execution& run) { return suggestLines(plain.mesh, {}, {}, run).status; } },
    { "sewing",
      [&](const Execution& run) {
        return sewPieces(*pieces.cut, pieces.positions, {}, run).status;
      } },
    { "reshaping",
      [&](const Execution& run) { return makeFlattenable(plain.mesh, {}, {}, run).status; } },
  };
  for (const auto& [name, run] : runs)
  {
    Caller caller;
    const Status status = run(caller.execution());
    EXPECT_FALSE(status.refused()) << name << ": " << status.message;
    EXPECT_GT(caller.asked, 0) << name;
    EXPECT_EQ(caller.elsewhere, 0) << name;
  }
}

TEST(Threads, InsideALoopHearThatTheCallerEndedTheRun)
{
  Execution execution;
  int asked = 0;
  execution.cancel = [&asked] { return ++asked == 2; };
  const Execution inner = execution.nestedExecution();
  const auto heardElsewhere = [&inner] {
    bool heard = false;
    std::thread([&] { heard = inner.cancelled(); }).join();
    return heard;
  };
  EXPECT_FALSE(heardElsewhere());
  EXPECT_FALSE(inner.cancelled());
  EXPECT_FALSE(heardElsewhere());
  EXPECT_TRUE(inner.cancelled());
  EXPECT_TRUE(heardElsewhere());
  EXPECT_TRUE(inner.cancelled());
  EXPECT_EQ(asked, 2);
}

TEST(Threads, ShareTasksHoweverFewTheyAre)
{
  Execution execution;
  execution.parallel = ThreadedLoop(2);
  std::mutex guard;
  std::condition_variable arrived;
  int here = 0;
  int met = 0;
  execution.forEachTask(2, [&](Index) {
    std::unique_lock<std::mutex> lock(guard);
    ++here;
    arrived.notify_all();
    met += arrived.wait_for(lock, std::chrono::seconds(10), [&] { return here == 2; }) ? 1 : 0;
  });
  EXPECT_EQ(met, 2);
}
