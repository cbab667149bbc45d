// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out is a status of its own, whatever wanted it.
#include "Base/LargeArray.h"
#include "Base/Memory.h"
#include "Flattened.h"
#include "Reference/SuperLUFactorization.h"
#include "TestGraphs.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <numeric>

using namespace flattening;
using namespace testmeshes;

namespace
{
struct Result
{
  Status status;
};

std::size_t addressSpace()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * 4096;
}

/// Runs with ever more memory until there is enough. \param step in kilobytes. \return the exit
/// code: 0 where each run before the last ended as OutOfMemory, and there were some.
int runWithMoreAndMoreMemory(const std::function<Status()>& run, std::size_t step)
{
  const std::size_t held = addressSpace();
  int refused = 0;
  for (std::size_t more = 0; more < 512 * 1024; more += step)
  {
    const rlimit limit{ held + (more << 10U), RLIM_INFINITY };
    setrlimit(RLIMIT_AS, &limit);
    const Status status = run();
    const rlimit all{ RLIM_INFINITY, RLIM_INFINITY };
    setrlimit(RLIMIT_AS, &all);
    if (status.ok())
    {
      return refused > 0 ? 0 : 1;
    }
    if (status.code != StatusCode::OutOfMemory)
    {
      std::fprintf(stderr, "%s with %d KB\n", status.message.c_str(), static_cast<int>(more));
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
    { Scheme::Progressive, Scheme::Global, Scheme::Isometric, Scheme::LeastSquaresConformal })
  {
    FlatteningOptions options = withScheme(scheme);
    FlatteningCache cache;
    Execution execution = withThreads(3);
    execution.factorMemory = 10000;
    const FlatteningResult refused = flatten(surface, options, execution, &cache);
    EXPECT_EQ(refused.status.code, StatusCode::OutOfMemory);
    EXPECT_TRUE(refused.status.refused());
    EXPECT_NE(refused.status.message.find("wants"), std::string::npos) << refused.status.message;
    EXPECT_TRUE(refused.positions.empty());
    // What was left half done serves no later run.
    const FlatteningResult after = flatten(surface, options, {}, &cache);
    const FlatteningResult fresh = flattenSurface(surface.mesh, {}, options, {});
    EXPECT_TRUE(after.status.ok()) << after.status.message;
    EXPECT_EQ(after.positions, fresh.positions);
  }
}

TEST(OutOfMemory, DoesNotEndTheProgramInTheLibraryOfThePapersSolver)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const Eigen::SparseMatrix<double> matrix = testgraphs::gridLaplacian(120);
  const Eigen::MatrixXd rightHandSides = Eigen::MatrixXd::Ones(matrix.rows(), 2);
  const auto solve = [&]() -> Result {
    SuperLUFactorization solver;
    const bool solved =
      solver.factorize(matrix) && solver.solve(rightHandSides).rows() == matrix.rows();
    return { solved ? Status() : Status{ StatusCode::NumericalFailure, "not solved", {} } };
  };
  const auto run = [&] { return withinMemory(solve).status; };
  // OpenBLAS, where it is installed, waits for its first buffer for ever: let it have that before.
  ASSERT_TRUE(solve().status.ok());
  // Steps so small that the memory ends in each of the library's own steps.
  EXPECT_EXIT(std::_Exit(runWithMoreAndMoreMemory(run, 64)), testing::ExitedWithCode(0), "");
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
  const Result result = withinMemory([]() -> Result {
    std::vector<double> endless;
    endless.reserve(endless.max_size());
    endless.resize(endless.max_size() + 1);
    return {};
  });
  EXPECT_EQ(result.status.code, StatusCode::OutOfMemory);
  const Result large = withinMemory([]() -> Result {
    LargeArray<double> endless;
    endless.resize(endless.max_size());
    return {};
  });
  EXPECT_EQ(large.status.code, StatusCode::OutOfMemory);
}

TEST(LargeArray, HoldsItsValuesAtLengthsAroundThoseOfPages)
{
  for (const std::size_t bytes : { 0U, 1U << 16U, 1U << 19U, 1U << 21U, 5U << 19U, 7U << 20U })
  {
    for (const std::size_t count : { bytes / sizeof(double), bytes / sizeof(double) + 1 })
    {
      LargeArray<double> values(count);
      std::iota(values.begin(), values.end(), 1.0);
      const LargeArray<double> copy = values;
      values.resize(3 * count, -1.0);
      EXPECT_TRUE(std::equal(copy.begin(), copy.end(), values.begin()));
      EXPECT_EQ(std::count(values.begin(), values.end(), -1.0), std::ptrdiff_t(2 * count));
    }
  }
}

TEST(OutOfMemory, ThreadsThatAreNotGivenAreToldWithTheSystemsReason)
{
  for (const char* reason : { "Resource temporarily unavailable", "Operation not permitted" })
  {
    for (const int rings : { 4, 12 })
    {
      Execution execution;
      execution.parallel = [reason](Index, const std::function<void(Index, Index)>&) {
        throw SystemLimit(reason);
      };
      const Surface surface = cushion(rings, rings, 0.4);
      const PreparedSurface prepared =
        prepareSurface(surface.mesh.points(), surface.mesh.triangles());
      const Status status =
        flattenSurface(prepared.mesh, {}, FlatteningOptions(), execution, nullptr).status;
      EXPECT_EQ(status.code, StatusCode::OutOfMemory);
      EXPECT_NE(status.message.find(std::string("(") + reason + ")"), std::string::npos)
        << status.message;
      EXPECT_NE(status.message.find("the limit of threads was met"), std::string::npos);
      ASSERT_EQ(status.remedies.size(), 2U);
      EXPECT_EQ(status.remedies[0].subject, "a higher limit of processes (ulimit -u)");
    }
  }
}
