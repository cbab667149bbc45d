// SPDX-License-Identifier: BSD-3-Clause
#include "FlattenToFiles.h"

#include "OutputFiles.h"
#include "Report.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <system_error>

namespace wirewarp
{
namespace
{
using Clock = std::chrono::steady_clock;

/// A pattern of an earlier run must not be cut for this one's.
void discardPatterns(const OutputFiles& files)
{
  for (const char* name : { "pattern.svg", "pattern.pdf", "pattern.dxf" })
  {
    files.discard(name);
  }
}

/// \return the names of the patterns among the files
std::vector<std::string> writeResult(const Options& options, Flattening& result, OutputFiles& files)
{
  const Clock::time_point start = Clock::now();
  std::vector<std::string> patterns = addPatterns(options.pattern, options.surface, result, files);
  files.add("flat.vtp", result.flat);
  files.add("wires.vtp", result.wires);
  files.add("cut.vtp", result.cut);
  result.secondsWrite = std::chrono::duration<double>(Clock::now() - start).count();
  result.secondsTotal += result.secondsWrite;
  files.add("report.json", makeReport(options, result));
  discardPatterns(files);
  files.publish();
  return patterns;
}

/// Says so in report.json, and leaves no earlier result beside it.
void writeRefusal(const Options& options, const Flattening& result, OutputFiles& files)
{
  files.add("report.json", makeReport(options, result));
  for (const char* name : { "flat.vtp", "wires.vtp", "cut.vtp" })
  {
    files.discard(name);
  }
  discardPatterns(files);
  files.publish();
}
}

//------------------------------------------------------------------------------
FilesOfFlattening flattenToFiles(const Options& options)
{
  FilesOfFlattening written;
  written.folder = outputFolder(options);
  std::error_code ignored;
  std::optional<OutputFiles> files; // a default folder is not made for a refusal alone
  if (!options.output.empty() || std::filesystem::is_directory(written.folder, ignored))
  {
    files.emplace(written.folder);
  }
  written.result = flattenOne(options);
  if (written.result.refused())
  {
    if (files)
    {
      writeRefusal(options, written.result, *files);
    }
    return written;
  }
  if (!files)
  {
    files.emplace(written.folder);
  }
  std::optional<OutputFiles> picture;
  if (options.picture.any())
  {
    picture.emplace(options.picture.folder(), "--picture");
    addPicture(options, written.result, *picture);
  }
  written.patterns = writeResult(options, written.result, *files);
  if (picture)
  {
    picture->publish();
  }
  return written;
}
}
