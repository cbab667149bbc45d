// SPDX-License-Identifier: BSD-3-Clause
// Several pieces and wire-patches on several threads. Built with -fsanitize=thread it also shows
// that the threads do not race (see Testing/Fuzz/README.md).
#include "Flattening/SurfaceFlattening.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <thread>

using namespace flattening;
using namespace testmeshes;

namespace
{
Execution onThreads(Index threads)
{
  Execution execution;
  execution.cancel = [] { return false; };
  execution.parallel = [threads](Index count, const std::function<void(Index, Index)>& body) {
    std::vector<std::thread> workers;
    for (Index k = 0; k < threads; ++k)
    {
      const Index begin = count * k / threads;
      const Index end = count * (k + 1) / threads;
      if (begin < end)
      {
        workers.emplace_back([&body, begin, end] { body(begin, end); });
      }
    }
    for (std::thread& worker : workers)
    {
      worker.join();
    }
  };
  return execution;
}
}

TEST(Threads, GiveEverySchemeTheSameResultBitByBit)
{
  constexpr Index size = 12;
  Surface surface = cushion(size, size, 0.3);
  FeatureCurve seam = columnCurve(size, size, 4);
  seam.type = CurveType::Seam;
  surface.curves = { seam, rowCurve(size, 4), rowCurve(size, 8), columnCurve(size, size, 8) };
  for (const Scheme scheme :
    { Scheme::Progressive, Scheme::Global, Scheme::Isometric, Scheme::Conformal })
  {
    for (const InteriorMethod interior :
      { InteriorMethod::Laplacian, InteriorMethod::Relaxation, InteriorMethod::AsRigidAsPossible })
    {
      FlatteningOptions options;
      options.scheme = scheme;
      options.interior.method = interior;
      const FlatteningResult alone = flattenSurface(surface.mesh, surface.curves, options, {});
      const FlatteningResult shared =
        flattenSurface(surface.mesh, surface.curves, options, onThreads(4));
      ASSERT_FALSE(alone.status.refused()) << alone.status.message;
      ASSERT_EQ(alone.pieces.size(), 2U);
      EXPECT_EQ(alone.status.message, shared.status.message);
      EXPECT_EQ(alone.positions, shared.positions);
    }
  }
}
