// SPDX-License-Identifier: BSD-3-Clause
// Runs with a cache, one after another with other curves, schemes and materials, beside fresh runs.
#include "../Core/SameResult.h"
#include "Cloth/ClothMaterial.h"
#include "HostileCase.h"

#include <gtest/gtest.h>

#include <limits>

using namespace hostile;

namespace
{
/// What a window changes between two updates, as the random number says.
void change(std::mt19937& random, const std::vector<FeatureCurve>& all,
  std::vector<FeatureCurve>& curves, FlatteningOptions& options)
{
  const auto below = [&random](std::size_t count) { return random() % count; };
  switch (below(8))
  {
    case 0:
    case 1:
      options.scheme = static_cast<Scheme>(below(4));
      break;
    case 2:
      options.interior.method = static_cast<InteriorMethod>(below(3));
      break;
    case 3:
      options.cloth.reset();
      if (below(2) == 0)
      {
        options.cloth.emplace();
        options.cloth->material = materialPresets()[below(materialPresets().size())];
      }
      break;
    case 4:
      options.closeCuts = !options.closeCuts;
      options.skipClosed = !options.skipClosed;
      break;
    case 5:
      curves = all;
      break;
    case 6:
      if (!curves.empty())
      {
        curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(below(curves.size())));
      }
      break;
    default:
      if (!curves.empty())
      {
        curves[below(curves.size())].type = static_cast<CurveType>(below(4));
      }
  }
}

void expectSameRun(const FlatteningResult& cached, const FlatteningResult& fresh)
{
  testmeshes::expectSame(cached, fresh);
  EXPECT_EQ(cached.status.message, fresh.status.message);
  EXPECT_EQ(cached.leftOut.size(), fresh.leftOut.size());
  ASSERT_EQ(cached.pieces.size(), fresh.pieces.size());
  for (std::size_t p = 0; p < fresh.pieces.size(); ++p)
  {
    const PieceReport& a = cached.pieces[p];
    const PieceReport& b = fresh.pieces[p];
    EXPECT_STREQ(statusName(a.status.code), statusName(b.status.code));
    EXPECT_EQ(a.status.message, b.status.message);
    EXPECT_EQ(a.fallbacks, b.fallbacks);
    EXPECT_EQ(a.iterations, b.iterations);
    EXPECT_EQ(a.objective, b.objective);
    EXPECT_EQ(a.distortionEnergy, b.distortionEnergy);
    EXPECT_EQ(a.angleEnergy, b.angleEnergy);
    EXPECT_EQ(a.cutLength, b.cutLength);
    EXPECT_EQ(a.released, b.released);
  }
}

/// An ordinary surface with its curves on edges, and its options; its status where there is none.
ImprintedSurface makeCase(std::mt19937& random, FlatteningOptions& options)
{
  const std::vector<std::uint8_t> input = randomBytes(random);
  Bytes bytes(input);
  const HostileCase given = decodeOrdinaryCase(bytes, {});
  options = given.options;
  const PreparedSurface surface = prepareSurface(given.points, given.triangles, given.coincident);
  ImprintedSurface imprinted;
  imprinted.status = surface.status;
  return surface.status.ok() ? imprintCurves(surface.mesh, given.polylines, given.imprint, {})
                             : imprinted;
}

/// Ends ordinary runs at some of their questions. \return how many of them were cancelled
unsigned cancelRuns(unsigned first, unsigned count)
{
  unsigned cancelled = 0;
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    FlatteningOptions options;
    const ImprintedSurface imprinted = makeCase(random, options);
    if (!imprinted.status.ok())
    {
      continue;
    }
    options.scheme = Scheme::Isometric;
    Index questions = 0;
    Index last = std::numeric_limits<Index>::max();
    Execution execution;
    execution.cancel = [&] { return questions++ >= last; };
    const auto run = [&] {
      return flattenSurface(imprinted.mesh, imprinted.curves, options, execution);
    };
    run();
    const Index all = questions;
    for (int k = 0; k < 12; ++k)
    {
      last = static_cast<Index>(random() % static_cast<unsigned>(all + 1));
      questions = 0;
      const FlatteningResult result = run();
      const bool ended = result.status.code == StatusCode::Cancelled;
      EXPECT_TRUE(ended || result.status.refused() ||
        result.positions.size() == static_cast<std::size_t>(result.cut->mesh.vertexCount()));
      cancelled += ended ? 1 : 0;
    }
  }
  return cancelled;
}

void tryChanges(unsigned first, unsigned count)
{
  unsigned flattened = 0;
  for (unsigned seed = first; seed < first + count && !testing::Test::HasFailure(); ++seed)
  {
    std::mt19937 random(seed);
    FlatteningOptions options;
    const ImprintedSurface imprinted = makeCase(random, options);
    if (!imprinted.status.ok())
    {
      continue;
    }
    std::vector<FeatureCurve> curves = imprinted.curves;
    FlatteningCache cache;
    for (int update = 0; update < 5; ++update)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", update " + std::to_string(update));
      const FlatteningResult cached = flattenSurface(imprinted.mesh, curves, options, {}, &cache);
      const FlatteningResult fresh = flattenSurface(imprinted.mesh, curves, options, {});
      expectSameRun(cached, fresh);
      flattened += fresh.status.refused() ? 0 : 1;
      change(random, imprinted.curves, curves, options);
    }
  }
  EXPECT_GT(flattened, count); // or the changes are of nothing
}
}

TEST(OrdinaryFew, ChangesWithACacheGiveWhatFreshRunsGive)
{
  tryChanges(0, 60);
}

TEST(OrdinaryCases, ManyChangesWithACacheGiveWhatFreshRunsGive)
{
  tryChanges(1000, 2000);
}

TEST(OrdinaryFew, RunsThatAreCancelledAnywhereEndSo)
{
  EXPECT_GT(cancelRuns(0, 60), 100U);
}

TEST(OrdinaryCases, ManyRunsThatAreCancelledAnywhereEndSo)
{
  EXPECT_GT(cancelRuns(1000, 600), 1000U);
}
