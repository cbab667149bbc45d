// SPDX-License-Identifier: BSD-3-Clause
#include "GrowthReporter.h"

#include <cmath>
#include <cstdio>

namespace benchmarks
{
namespace
{
/// Slope of the line through the logarithms, by least squares.
double exponent(const std::vector<std::pair<double, double>>& times)
{
  double x = 0.0;
  double y = 0.0;
  for (const auto& [triangles, seconds] : times)
  {
    x += std::log(triangles) / static_cast<double>(times.size());
    y += std::log(seconds) / static_cast<double>(times.size());
  }
  double xx = 0.0;
  double xy = 0.0;
  for (const auto& [triangles, seconds] : times)
  {
    xx += (std::log(triangles) - x) * (std::log(triangles) - x);
    xy += (std::log(triangles) - x) * (std::log(seconds) - y);
  }
  return xy / xx;
}
}

void GrowthReporter::ReportRuns(const std::vector<Run>& runs)
{
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs)
  {
    const auto triangles = run.counters.find("triangles");
    const bool counts =
      run.repetitions > 1 ? run.aggregate_name == "median" : run.run_type == Run::RT_Iteration;
    if (!counts || run.error_occurred || triangles == run.counters.end())
    {
      continue;
    }
    const std::string& name = run.run_name.function_name;
    const std::string stage = name.substr(0, name.rfind('/'));
    std::vector<std::pair<double, double>>& times = this->Times[stage];
    if (times.empty())
    {
      this->Stages.push_back(stage);
    }
    const bool manual = run.run_name.time_type == "manual_time";
    times.emplace_back(static_cast<double>(triangles->second),
      manual ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime());
  }
}

void GrowthReporter::Finalize()
{
  ConsoleReporter::Finalize();
  std::printf("\n| stage | exponent |\n|---|---|\n");
  for (const std::string& stage : this->Stages)
  {
    const auto& times = this->Times[stage];
    if (times.size() > 1)
    {
      std::printf("| %s | %.2f |\n", stage.c_str(), exponent(times));
    }
  }
}
}
