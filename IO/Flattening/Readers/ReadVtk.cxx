// SPDX-License-Identifier: BSD-3-Clause
#include "ReadVtk.h"

#include "DataSetBytes.h"
#include "GuardedProcess.h"
#include "InputError.h"
#include "TextFile.h"

#include <csignal>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace wirewarp
{
namespace
{
constexpr std::size_t megabyte = std::size_t(1) << 20;

/// Far above what files that are whole take: VTK reads some 20 MB of text a second, and its data
/// take some ten times the bytes of a file, more only where it is packed well.
ProcessLimits limitsFor(std::size_t fileSize)
{
  const auto megabytes = static_cast<long long>(fileSize / megabyte);
  ProcessLimits limits;
  limits.cpu = std::chrono::seconds(4 + megabytes);
  limits.wall = std::chrono::seconds(60 + 4 * megabytes);
  limits.memory = 1024 * megabyte + 200 * fileSize;
  return limits;
}

std::string failure(const ProcessAnswer& answer, const ProcessLimits& limits)
{
  const std::string writeAgain = "; write the file again";
  const std::string damaged = "is damaged: VTK's reader ";
  if (answer.end == ProcessEnd::TooLong)
  {
    const auto seconds = answer.signal != 0 ? limits.cpu : limits.wall;
    return damaged + "came to no end within " + std::to_string(seconds.count()) + " s" + writeAgain;
  }
  if (answer.end == ProcessEnd::Signal)
  {
    return damaged + "ended by signal " + std::to_string(answer.signal) + " (" +
      strsignal(answer.signal) + ")" +
      (answer.signal == SIGKILL ? "; if memory ran out, try a smaller file" : writeAgain);
  }
  if (answer.exitCode == 127)
  {
    return std::string("cannot be read: the program that reads it could not be loaded; ") +
      wayOutOfMemory + ", or install the program again";
  }
  return damaged + "gave no answer" + writeAgain;
}
}

DataSet readVtk(const std::string& path)
{
  const ProcessLimits limits = limitsFor(checkedFileSize(path));
  ProcessAnswer result;
  try
  {
    result = runGuarded(limits, helperProgram("wirewarp-read"), { path });
  }
  catch (const std::runtime_error& error)
  {
    throw InputError(path, error.what());
  }
  if (result.end != ProcessEnd::Answered || result.bytes.empty())
  {
    throw InputError(path, failure(result, limits));
  }
  const std::string_view content = std::string_view(result.bytes).substr(1);
  if (result.bytes.front() != vtkAnswerData)
  {
    throw InputError(path, std::string(content));
  }
  try
  {
    return unpackDataSet(content);
  }
  catch (const std::runtime_error& error)
  {
    throw InputError(path, error.what() + std::string("; write the file again"));
  }
}
}
