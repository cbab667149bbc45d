// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out is a status of its own, whatever wanted it.
#include "Base/Memory.h"
#include "Flattening/SurfaceFlattening.h"
#include "Surface/SurfacePreparation.h"
#include "TestThreads.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cstdlib>
#include <fstream>

using namespace flattening;
using namespace testmeshes;

namespace
{
std::size_t addressSpace()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * 4096;
}

/// Flattens with ever more memory until there is enough. \return the exit code: 0 where each run
/// before that one ended as OutOfMemory, and there were some.
int flattenWithMoreAndMoreMemory(const Surface& surface, Scheme scheme)
{
  FlatteningOptions options;
  options.scheme = scheme;
  const std::size_t held = addressSpace();
  int refused = 0;
  for (std::size_t more = 0; more < 512; more += 1 + more / 4)
  {
    const rlimit limit{ held + (more << 20U), RLIM_INFINITY };
    setrlimit(RLIMIT_AS, &limit);
    const Status status = flattenSurface(surface.mesh, {}, options, {}).status;
    const rlimit all{ RLIM_INFINITY, RLIM_INFINITY };
    setrlimit(RLIMIT_AS, &all);
    if (status.ok())
    {
      return refused > 0 ? 0 : 1;
    }
    if (status.code != StatusCode::OutOfMemory)
    {
      std::fprintf(stderr, "%s with %d MB\n", status.message.c_str(), static_cast<int>(more));
      return 2;
    }
    ++refused;
  }
  return 3;
}
}

TEST(OutOfMemory, IsTheStatusOfARunWhoseFactorsMayNotBeAsLargeAndTellsHowLargeTheyAre)
{
  const Surface surface = cushion(20, 20, 0.4);
  for (Scheme scheme :
    { Scheme::Progressive, Scheme::Global, Scheme::Isometric, Scheme::Conformal })
  {
    FlatteningOptions options;
    options.scheme = scheme;
    FlatteningCache cache;
    Execution execution = withThreads(3);
    execution.factorMemory = 10000;
    const FlatteningResult refused = flattenSurface(surface.mesh, {}, options, execution, &cache);
    EXPECT_EQ(refused.status.code, StatusCode::OutOfMemory);
    EXPECT_TRUE(refused.status.refused());
    EXPECT_NE(refused.status.message.find("wants"), std::string::npos) << refused.status.message;
    EXPECT_TRUE(refused.positions.empty());
    // What was left half done serves no later run.
    const FlatteningResult after = flattenSurface(surface.mesh, {}, options, {}, &cache);
    const FlatteningResult fresh = flattenSurface(surface.mesh, {}, options, {});
    EXPECT_TRUE(after.status.ok()) << after.status.message;
    EXPECT_EQ(after.positions, fresh.positions);
  }
}

TEST(OutOfMemory, IsTheStatusWhereverTheSystemsLimitIsMet)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const Surface surface = cushion(90, 90, 0.4);
  for (Scheme scheme : { Scheme::Global, Scheme::Isometric, Scheme::Conformal })
  {
    EXPECT_EXIT(
      std::_Exit(flattenWithMoreAndMoreMemory(surface, scheme)), testing::ExitedWithCode(0), "");
  }
}

TEST(OutOfMemory, OnAnotherThreadReachesTheCaller)
{
  const Execution execution = withThreads(3);
  EXPECT_THROW(execution.parallelFor(30,
                 [](Index begin, Index) {
                   if (begin > 0)
                   {
                     throw OutOfMemory(77);
                   }
                 }),
    OutOfMemory);
}

TEST(OutOfMemory, OfAVectorThatNoMachineHoldsIsToldAsWell)
{
  struct Result
  {
    Status status;
  };
  const Result result = withinMemory([]() -> Result {
    std::vector<double> endless;
    endless.reserve(endless.max_size());
    endless.resize(endless.max_size() + 1);
    return {};
  });
  EXPECT_EQ(result.status.code, StatusCode::OutOfMemory);
}
