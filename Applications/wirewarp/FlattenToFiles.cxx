// SPDX-License-Identifier: BSD-3-Clause
#include "FlattenToFiles.h"

#include "InputError.h"
#include "OutputFiles.h"
#include "Patterns.h"
#include "Report.h"
#include "Sizes.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>

namespace wirewarp
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr std::array<const char*, 3> dataNames{ "flat.vtp", "wires.vtp", "cut.vtp" };
constexpr const char* curvesName = "curves.vtp";
constexpr const char* flattenableName = "flattenable.vtp";
constexpr const char* sewnName = "sewn.vtp";
constexpr std::array<const char*, 11> patternNames{ "pattern.svg", "pattern.pdf", "pattern.dxf",
  "pattern.plt", "pattern.json", "walk.csv", "lay.svg", "lay.plt", "nest.svg", "rules.csv",
  "pattern.rul" };
constexpr const char* reportName = "report.json";

InputFiles inputFiles(const Options& options)
{
  InputFiles inputs;
  inputs.add(options.surface);
  for (const std::string& path : options.curves)
  {
    inputs.add(path);
  }
  if (!options.body.empty())
  {
    inputs.add(options.body);
  }
  for (const SizeSurface& size : options.sizes.all(options.pattern.size))
  {
    if (!size.surface.empty())
    {
      inputs.add(size.surface);
    }
  }
  return inputs;
}

/// A pattern of an earlier run must not be cut for this one's.
void discardPatterns(OutputFiles& files)
{
  for (const char* name : patternNames)
  {
    files.discard(name);
  }
}

/// \return the names of the patterns among the files
std::vector<std::string> writeResult(const Options& options, Flattening& result, OutputFiles& files)
{
  const Clock::time_point start = Clock::now();
  std::vector<std::string> patterns =
    addPatterns(options.pattern, options.surface, options.quiet, result, files);
  files.add(dataNames[0], result.flat);
  files.add(dataNames[1], result.wires);
  files.add(dataNames[2], result.cut);
  vtkPolyData* const curves = result.flattenable ? result.flattenableCurves : result.curves;
  if (curves)
  {
    files.add(curvesName, curves);
  }
  if (result.flattenable)
  {
    files.add(flattenableName, result.flattenable);
  }
  if (result.sewn)
  {
    files.add(sewnName, result.sewn);
  }
  result.secondsWrite = std::chrono::duration<double>(Clock::now() - start).count();
  result.secondsTotal += result.secondsWrite;
  files.add(reportName, makeReport(options, result));
  discardPatterns(files);
  if (!result.sewn)
  {
    files.discard(sewnName);
  }
  files.publish();
  return patterns;
}

/// Says so in report.json, and leaves no earlier result beside it but what a user may have edited
/// since: curves and a moved surface.
void writeRefusal(const Options& options, const Flattening& result, OutputFiles& files)
{
  files.add(reportName, makeReport(options, result));
  for (const char* name : dataNames)
  {
    files.discard(name);
  }
  files.discard(sewnName);
  discardPatterns(files);
  files.publish();
}
}

//------------------------------------------------------------------------------
void refuseToReplaceInputs(const InputFiles& inputs, const Options& options)
{
  const std::filesystem::path folder = outputFolder(options);
  for (const char* name : dataNames)
  {
    inputs.refuseToReplace(folder / name, "--output");
  }
  for (const char* name : patternNames)
  {
    inputs.refuseToReplace(folder / name, "--output");
  }
  inputs.refuseToReplace(folder / reportName, "--output");
  if (!options.suggest.empty() || options.reshaping.any())
  {
    inputs.refuseToReplace(folder / curvesName, "--output");
  }
  if (options.reshaping.any())
  {
    inputs.refuseToReplace(folder / flattenableName, "--output");
  }
  inputs.refuseToReplace(folder / sewnName, "--output");
  if (options.picture.any())
  {
    inputs.refuseToReplace(options.picture.path, "--picture");
  }
}

//------------------------------------------------------------------------------
FilesOfFlattening flattenToFiles(const Options& options)
{
  FilesOfFlattening written;
  written.folder = outputFolder(options);
  refuseToReplaceInputs(inputFiles(options), options);
  std::error_code ignored;
  std::optional<OutputFiles> files; // a default folder is not made for a refusal alone
  if (!options.output.empty() || std::filesystem::is_directory(written.folder, ignored))
  {
    files.emplace(written.folder);
    files->claim();
  }
  std::optional<OutputFiles> picture; // before the work, which would be lost
  if (options.picture.any())
  {
    picture.emplace(options.picture.folder(), "--picture");
  }
  written.result = flattenOne(options);
  if (options.sizes.any() && !written.result.refused())
  {
    gradeSizes(options, written.result);
  }
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
    files->claim();
  }
  try
  {
    try
    {
      if (picture)
      {
        addPicture(options, written.result, *picture);
        written.picture = true;
      }
    }
    catch (const InputError& error)
    {
      written.result.unwritten.emplace_back(error.what());
    }
    written.patterns = writeResult(options, written.result, *files);
    if (written.picture)
    {
      picture->publish();
    }
  }
  catch (const std::bad_alloc&)
  {
    written.result = outOfMemory(options.surface);
    files->abandon();
    writeRefusal(options, written.result, *files);
  }
  return written;
}
}
