// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "Base/Stopwatch.h"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

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
    execution.parallel = [threads](flattening::Index count,
                           const std::function<void(flattening::Index, flattening::Index)>& body) {
      const flattening::Index parts = std::min<flattening::Index>(threads, count);
      std::vector<std::thread> others;
      for (flattening::Index k = 1; k < parts; ++k)
      {
        others.emplace_back(body, k * count / parts, (k + 1) * count / parts);
      }
      if (parts > 0)
      {
        body(0, count / parts);
      }
      for (std::thread& other : others)
      {
        other.join();
      }
    };
  }
  return execution;
}
}
