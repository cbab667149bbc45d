// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "Base/Stopwatch.h"

#include <vtkSMPTools.h>

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>

namespace benchmarks
{
namespace
{
/// A line of the kernel's account of this process, in bytes.
double statusBytes(const std::string& key)
{
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;
       file.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
  {
    if (word == key)
    {
      double kibibytes = 0.0;
      file >> kibibytes;
      return 1024.0 * kibibytes;
    }
  }
  return 0.0;
}

void resetPeak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}
}

Measured measure(const Repeats& repeats, const std::function<double()>& job)
{
  Measured result;
  std::vector<double> processor;
  resetPeak();
  const double before = statusBytes("VmRSS:");
  const flattening::Stopwatch watch;
  do
  {
    const std::clock_t start = std::clock();
    const flattening::Stopwatch run;
    const double seconds = job();
    const double share = seconds / run.seconds(); // of the run counts
    result.runs.push_back(seconds);
    processor.push_back(share * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (result.runs.size() == 1)
    {
      result.peakBytes = statusBytes("VmHWM:") - before;
    }
  } while (
    static_cast<int>(result.runs.size()) < repeats.most && watch.seconds() < repeats.seconds);
  std::sort(result.runs.begin(), result.runs.end());
  std::sort(processor.begin(), processor.end());
  result.seconds = result.runs[result.runs.size() / 2];
  result.processor = processor[processor.size() / 2];
  return result;
}

flattening::Execution threadedExecution(int threads)
{
  flattening::Execution execution;
  if (threads > 1)
  {
    vtkSMPTools::Initialize(threads);
    execution.parallel = [](flattening::Index count,
                           const std::function<void(flattening::Index, flattening::Index)>& body) {
      vtkSMPTools::For(0, count, [&body](vtkIdType begin, vtkIdType end) {
        body(static_cast<flattening::Index>(begin), static_cast<flattening::Index>(end));
      });
    };
  }
  return execution;
}
}
