// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"

#include <algorithm>
#include <vector>

namespace flattening
{
/// Calls compute(k), which gives a Result, on threads for each number below `count`, and
/// add(k, result) on the calling one in their order, so that sums do not depend on threads.
template <typename Result, typename Compute, typename Add>
void computeAndAdd(Index count, const Execution& execution, const Compute& compute, const Add& add)
{
  // Results at a time: few enough for the cache, many enough for threads.
  constexpr Index together = 4096;
  std::vector<Result> results(std::min(count, together));
  for (Index first = 0; first < count; first += together)
  {
    const Index here = std::min(together, count - first);
    execution.parallelFor(here, [&](Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
      {
        results[k] = compute(first + k);
      }
    });
    for (Index k = 0; k < here; ++k)
    {
      add(first + k, results[k]);
    }
  }
}
}
