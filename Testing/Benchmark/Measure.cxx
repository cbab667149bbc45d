// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "Base/Execution.h"

#include <vtkSMPTools.h>

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace benchmarks
{
using namespace flattening;

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

/// Of the runs and of what they took of the processor.
void takeMedians(std::vector<double>& processor, Measured& result)
{
  std::sort(result.runs.begin(), result.runs.end());
  std::sort(processor.begin(), processor.end());
  result.seconds = result.runs[result.runs.size() / 2];
  result.processor = processor[processor.size() / 2];
}
}

Measured measure(const Repeats& repeats, const std::function<double()>& job)
{
  Measured result;
  std::vector<double> processor;
  resetPeak();
  const double before = statusBytes("VmRSS:");
  const Stopwatch watch;
  do
  {
    const std::clock_t start = std::clock();
    const Stopwatch run;
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
  takeMedians(processor, result);
  return result;
}

Measured runProgram(const std::string& program, const TriangleMesh& mesh, const Repeats& repeats)
{
  const std::filesystem::path path =
    std::filesystem::temp_directory_path() / ("disk" + std::to_string(getpid()) + ".obj");
  std::ostringstream obj;
  obj.precision(17);
  for (const Point3& p : mesh.points())
  {
    obj << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (const Triangle& t : mesh.triangles())
  {
    obj << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  writeFile(path.string(), obj.str());
  const std::string command =
    "'" + program + "' '" + path.string() + "' " + std::to_string(repeats.most);
  std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  Measured result;
  std::vector<double> processor;
  double seconds = 0.0;
  double busy = 0.0;
  while (output && std::fscanf(output.get(), "%lf %lf", &seconds, &busy) == 2)
  {
    result.runs.push_back(seconds);
    processor.push_back(busy);
  }
  const bool ended = output && pclose(output.release()) == 0;
  std::filesystem::remove(path);
  if (!ended || result.runs.empty())
  {
    throw std::runtime_error(program + " failed, or printed no times");
  }
  takeMedians(processor, result);
  return result;
}

void writeFile(const std::string& path, const std::string& content)
{
  std::ofstream file(path);
  file << content;
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write " + path);
  }
}

Execution threadedExecution(int threads)
{
  Execution execution;
  if (threads > 1)
  {
    vtkSMPTools::Initialize(threads);
    execution.parallel = [](Index count, const std::function<void(Index, Index)>& body) {
      vtkSMPTools::For(0, count, [&body](vtkIdType begin, vtkIdType end) {
        body(static_cast<Index>(begin), static_cast<Index>(end));
      });
    };
  }
  return execution;
}
}
