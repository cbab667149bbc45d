// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"

#include <functional>
#include <vector>

namespace benchmarks
{
struct Measured
{
  double seconds = 0.0;     ///< median
  double processor = 0.0;   ///< median of the processor seconds of all threads
  std::vector<double> runs; ///< seconds of each, in ascending order
  double peakBytes = 0.0;   ///< of memory in use above what was in use before, in the first run
};

struct Repeats
{
  int most = 5;
  double seconds = 60.0; ///< no further run once so much time has passed
};

/// Runs a job several times; it returns the seconds to count.
Measured measure(const Repeats& repeats, const std::function<double()>& job);

/// Runs loops on so many threads of VTK's, as the filters do.
flattening::Execution threadedExecution(int threads);
}
