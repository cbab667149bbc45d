// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace benchmarks
{
/// Prints, after the times, how each stage grows: the exponent k of the power n^k that fits its
/// processor times best, n being the counter `triangles`. Benchmarks are named stage/triangles.
class GrowthReporter : public benchmark::ConsoleReporter
{
public:
  GrowthReporter()
    : ConsoleReporter(OO_None)
  {
  }
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

private:
  /// Per stage, in the order of their first run: triangles and time.
  std::vector<std::string> Stages;
  std::map<std::string, std::vector<std::pair<double, double>>> Times;
};
}
