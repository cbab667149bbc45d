// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Execution.h"

#include <cstddef>
#include <functional>

namespace benchmarks
{
struct Measured
{
  double seconds = 0.0;   ///< median
  double peakBytes = 0.0; ///< of memory in use above what was in use before, in the first run
};

/// Runs a job several times; it returns the seconds to count.
Measured measure(int repeats, const std::function<double()>& job);

/// Runs loops on threads of its own, one range each.
flattening::Execution threadedExecution(int threads);
}
