// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"

#include <thread>
#include <vector>

namespace testmeshes
{
using namespace flattening;

/// Runs loops on so many threads, one range each.
inline Execution withThreads(Index count)
{
  Execution execution;
  execution.parallel = [count](Index total, const std::function<void(Index, Index)>& body) {
    std::vector<std::thread> workers;
    for (Index k = 0; k < count; ++k)
    {
      workers.emplace_back([=, &body] { body(total * k / count, total * (k + 1) / count); });
    }
    for (std::thread& worker : workers)
    {
      worker.join();
    }
  };
  return execution;
}
}
