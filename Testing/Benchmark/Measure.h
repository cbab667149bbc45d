// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Surface/TriangleMesh.h"

#include <functional>
#include <string>
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

/// Lets a program of the reader's own map a disk: it is given an OBJ file and how often to map it,
/// and prints a line a run: the seconds that pass and those of the processor, both of the map
/// alone, its mesh in memory. The bytes are unknown. Throws std::runtime_error where it fails or
/// prints anything else.
Measured runProgram(
  const std::string& program, const flattening::TriangleMesh& mesh, const Repeats& repeats);

/// Throws std::runtime_error where it cannot.
void writeFile(const std::string& path, const std::string& content);

/// Runs loops on so many threads of VTK's, as the filters do.
flattening::Execution threadedExecution(int threads);
}
