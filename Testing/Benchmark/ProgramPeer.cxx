// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramPeer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>

#include <unistd.h>

namespace benchmarks
{
namespace
{
using namespace flattening;

void writeObj(const TriangleMesh& mesh, const std::string& path)
{
  std::ofstream file(path);
  file.precision(17);
  for (const Point3& p : mesh.points())
  {
    file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (const Triangle& t : mesh.triangles())
  {
    file << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write " + path);
  }
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}
}

Measured runProgram(const std::string& program, const TriangleMesh& mesh, const Repeats& repeats)
{
  const std::filesystem::path path =
    std::filesystem::temp_directory_path() / ("disk" + std::to_string(getpid()) + ".obj");
  writeObj(mesh, path.string());
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
  std::sort(result.runs.begin(), result.runs.end());
  result.seconds = median(result.runs);
  result.processor = median(processor);
  return result;
}
}
