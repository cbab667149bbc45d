// SPDX-License-Identifier: BSD-3-Clause
// Seeded hostile cases through the decoder of the fuzz target, and the inputs that fuzzing has
// found.
#include "HostileSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

using namespace hostile;

namespace
{
using Input = std::vector<std::uint8_t>;

Verdict tryInput(const Input& input, const SizeRange& triangles)
{
  Bytes bytes(input);
  return tryCase(decodeCase(bytes, dataSpecimens(), triangles));
}

Verdict tryOrdinaryInput(const Input& input, const SizeRange& triangles)
{
  Bytes bytes(input);
  return tryCase(decodeOrdinaryCase(bytes, triangles));
}

/// Runs seeds [first, first + count) and tells what became of them.
void trySeeds(unsigned first, unsigned count, double secondsEach, const SizeRange& triangles = {},
  Verdict (*tryOne)(const Input&, const SizeRange&) = tryInput)
{
  ASSERT_GE(dataSpecimens().size(), 15U);
  std::map<std::string, unsigned> outcomes;
  double slowest = 0.0;
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    traceSeed(seed);
    std::mt19937 random(seed);
    const Verdict verdict = tryOne(randomBytes(random), triangles);
    EXPECT_EQ(verdict.fault, "") << "seed " << seed << ", at most " << triangles.most
                                 << " triangles";
    EXPECT_LT(verdict.seconds, secondsEach)
      << "seed " << seed << ", " << verdict.triangles << " triangles";
    ++outcomes[statusName(verdict.code)];
    slowest = std::max(slowest, verdict.seconds);
  }
  std::cout << "slowest " << slowest << " s;";
  for (const auto& [name, cases] : outcomes)
  {
    std::cout << ' ' << cases << ' ' << name;
  }
  std::cout << '\n';
  // A suite that only sees refusals tests little.
  EXPECT_GT(outcomes["Ok"], count / 20);
}

class HostileSmallCases : public testing::TestWithParam<unsigned>
{
};
}

TEST_P(HostileSmallCases, GetATrueAnswer)
{
  constexpr unsigned count = 1250;
  trySeeds(GetParam() * count, count, 20.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, HostileSmallCases, testing::Range(0U, 16U));

TEST(OrdinaryFew, ShapesOfEveryKindGetATrueAnswer)
{
  trySeeds(0, 200, 20.0, {}, tryOrdinaryInput);
}

TEST(OrdinaryCases, OfEveryKindGetATrueAnswer)
{
  trySeeds(1000, 4000, 20.0, {}, tryOrdinaryInput);
}

TEST(OrdinaryCases, OfMiddleSizeGetATrueAnswer)
{
  trySeeds(100000, 150, 120.0, { 1000.0, 20000.0 }, tryOrdinaryInput);
}

TEST(HostileCases, OfMiddleSizeGetATrueAnswer)
{
  trySeeds(100000, 200, 60.0, { 120.0, 2000.0 });
}

TEST(HostileCases, OfUpToAHundredThousandTrianglesGetATrueAnswer)
{
  trySeeds(200000, 16, 300.0, { 4000.0, 1e5 });
}

// Seed 1, or those to try by hand: HOSTILE_SEED=7, HOSTILE_COUNT=1000, HOSTILE_TRIANGLES=120, and
// HOSTILE_TRACE=1 to name each seed before it is tried.
TEST(HostileCases, NamedByTheEnvironmentGetATrueAnswer)
{
  trySeeds(fromEnvironment("HOSTILE_SEED", 1), fromEnvironment("HOSTILE_COUNT", 1), 60.0,
    { 1.0, static_cast<double>(fromEnvironment("HOSTILE_TRIANGLES", 120)) });
}

TEST(FuzzCorpus, EveryInputGetsATrueAnswer)
{
  unsigned count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FLATTENING_CORPUS_DIR))
  {
    std::ifstream file(entry.path(), std::ios::binary);
    const Input input{ std::istreambuf_iterator<char>(file), {} };
    for (const SizeRange& sizes : { fuzzedSizes, SizeRange() })
    {
      const Verdict verdict = tryInput(input, sizes);
      EXPECT_EQ(verdict.fault, "") << entry.path();
      EXPECT_LT(verdict.seconds, 20.0) << entry.path();
    }
    ++count;
  }
  EXPECT_GE(count, 10U);
}
