// SPDX-License-Identifier: BSD-3-Clause
#include "FlattenToFiles.h"

#include "InputError.h"
#include "OutputFiles.h"
#include "Patterns.h"
#include "PlainText.h"
#include "Progress.h"
#include "Report.h"
#include "Sizes.h"
#include "WriteData.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <new>
#include <set>
#include <system_error>

namespace wirewarp
{
namespace
{
using Clock = std::chrono::steady_clock;

/// Of the files that keep a result, without their ending.
constexpr std::array<const char*, 3> dataNames{ "flat", "wires", "cut" };
constexpr const char* sewnName = "sewn";
constexpr std::array<const char*, 11> allPatternNames{ "pattern.svg", "pattern.pdf", "pattern.dxf",
  "pattern.plt", "pattern.json", "walk.csv", "lay.svg", "lay.plt", "nest.svg", "rules.csv",
  "pattern.rul" };
constexpr const char* reportName = "report.json";

InputFiles inputFiles(const Options& options)
{
  InputFiles inputs;
  if (options.source.empty())
  {
    inputs.add(options.surface);
  }
  else
  {
    const std::filesystem::path source = std::filesystem::u8path(options.source);
    for (const char* name : dataNames)
    {
      inputs.add((source / (std::string(name) + ".vtp")).string());
    }
    inputs.add((source / reportName).string());
  }
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

/// Files of a run, by their places in the folder that keeps the result, if one does.
std::vector<std::filesystem::path> kept(
  const Options& options, const std::vector<const char*>& names)
{
  std::vector<std::filesystem::path> paths;
  for (const char* const name : options.output.empty() ? std::vector<const char*>() : names)
  {
    const std::filesystem::path path = std::filesystem::u8path(options.output) / name;
    paths.push_back(
      path.has_extension() ? path : path.parent_path() / (std::string(name) + dataExtension));
  }
  return paths;
}

std::vector<std::filesystem::path> dataFiles(const Options& options)
{
  return kept(options, { dataNames.begin(), dataNames.end() });
}

/// Those of an earlier run must not be cut for this one's.
std::vector<std::filesystem::path> formerPatterns(const Options& options)
{
  return kept(options, { allPatternNames.begin(), allPatternNames.end() });
}

/// The report, where one is kept: a result that is sewn or laid on cloth later has it beside it.
std::filesystem::path reportFile(const Options& options)
{
  const bool adds =
    (options.command == "sew" && options.outputs.empty()) || options.command == "nest";
  const std::string& folder = adds && !options.source.empty() ? options.source : options.output;
  return folder.empty() ? std::filesystem::path() : std::filesystem::u8path(folder) / reportName;
}

/// All that may be written beside data and report.
std::vector<std::filesystem::path> furtherFiles(const Options& options)
{
  std::vector<std::filesystem::path> paths;
  for (const PatternFile& file : options.pattern.files)
  {
    paths.push_back(std::filesystem::u8path(file.path));
  }
  for (const std::string& file :
    { options.curvesFile, options.surfaceFile, options.sewnFile, options.picture.path })
  {
    if (!file.empty())
    {
      paths.push_back(std::filesystem::u8path(file));
    }
  }
  return paths;
}

void writeResult(const Options& options, FilesOfFlattening& written, OutputFiles& files)
{
  Flattening& result = written.result;
  const Clock::time_point start = Clock::now();
  const auto add = [&](const std::filesystem::path& file, const Data& data) {
    if (data && !file.empty())
    {
      files.add(file, *data);
      written.files.push_back(file.string());
    }
  };
  try
  {
    if (options.picture.any())
    {
      addPicture(options, result, files);
      written.files.push_back(options.picture.path);
    }
  }
  catch (const InputError& error)
  {
    result.unwritten.emplace_back(error.what());
  }
  const std::vector<std::string> patterns = addPatterns(options, result, files);
  written.files.insert(written.files.end(), patterns.begin(), patterns.end());
  add(std::filesystem::u8path(options.curvesFile),
    result.flattenable ? result.flattenableCurves : result.curves);
  add(std::filesystem::u8path(options.surfaceFile), result.flattenable);
  add(std::filesystem::u8path(options.sewnFile), result.sewn);
  const std::array<Data, 3> data{ result.flat, result.wires, result.cut };
  std::vector<NamedData> named;
  for (const std::filesystem::path& file : dataFiles(options))
  {
    named.push_back({ file.string(), data[named.size()].get() });
  }
  flattening::eraseIf(named, [](const NamedData& file) { return !file.data; });
  const std::vector<std::string> bytes = bytesOf(named, Progress(true).execution(options.threads));
  for (std::size_t k = 0; k < named.size(); ++k)
  {
    files.add(named[k].file, bytes[k]);
    written.files.push_back(named[k].file);
  }
  result.secondsWrite = std::chrono::duration<double>(Clock::now() - start).count();
  result.secondsTotal += result.secondsWrite;
  if (const std::filesystem::path report = reportFile(options); !report.empty())
  {
    files.add(report, makeReport(options, result));
    written.files.push_back(report.string());
  }
  files.discard(formerPatterns(options));
  if (!result.sewn)
  {
    files.discard(kept(options, { sewnName }));
  }
  files.publish();
}

/// Says so in report.json, and leaves no earlier result beside it but what a user may have edited
/// since: curves and a moved surface.
void writeRefusal(const Options& options, const Flattening& result, OutputFiles& files)
{
  if (options.output.empty())
  {
    return;
  }
  files.add(reportFile(options), makeReport(options, result));
  files.discard(dataFiles(options));
  files.discard(formerPatterns(options));
  files.discard(kept(options, { sewnName }));
  files.publish();
}

/// Where files cannot be put is found before the work, which would be lost.
void demandPlaces(const Options& options, OutputFiles& files)
{
  std::set<std::filesystem::path> result{ reportFile(options).lexically_normal() };
  for (const std::filesystem::path& file : dataFiles(options))
  {
    result.insert(file.lexically_normal());
  }
  for (const std::filesystem::path& file : furtherFiles(options))
  {
    if (result.count(file.lexically_normal()) > 0)
    {
      throw InputError(file.string(), "is a file of the result itself; name another with --output");
    }
  }
  if (!options.output.empty())
  {
    files.demandFolder(std::filesystem::u8path(options.output));
    files.claim(std::filesystem::u8path(options.output));
  }
  std::set<std::filesystem::path> folders{ std::filesystem::u8path(options.output) };
  for (const std::filesystem::path& file : furtherFiles(options))
  {
    if (folders.insert(file.parent_path()).second)
    {
      files.demandFolder(file.parent_path());
    }
    files.demandPlace(file);
  }
  for (const std::filesystem::path& file : dataFiles(options))
  {
    files.demandPlace(file);
  }
  if (const std::filesystem::path report = reportFile(options); !report.empty())
  {
    files.demandPlace(report);
  }
}
}

void refuseToReplaceInputs(const InputFiles& inputs, const Options& options)
{
  for (const auto& files : { dataFiles(options), formerPatterns(options), furtherFiles(options),
         kept(options, { sewnName, reportName }) })
  {
    for (const std::filesystem::path& file : files)
    {
      inputs.refuseToReplace(file, "--output");
    }
  }
}

FilesOfFlattening flattenToFiles(const Options& given)
{
  Options options = given;
  if (!options.source.empty())
  {
    adoptReport(options);
  }
  FilesOfFlattening written;
  refuseToReplaceInputs(inputFiles(options), options);
  std::error_code ignored;
  const bool existed = std::filesystem::exists(std::filesystem::u8path(options.output), ignored);
  OutputFiles files;
  demandPlaces(options, files);
  written.result = flattenOne(options);
  if (options.sizes.any() && !written.result.refused())
  {
    gradeSizes(options, written.result);
  }
  if (written.result.refused())
  {
    if (existed || options.outputGiven)
    {
      writeRefusal(options, written.result, files);
    }
    else if (!options.output.empty()) // a default folder is not made for a refusal alone
    {
      std::filesystem::remove(std::filesystem::u8path(options.output), ignored);
    }
    return written;
  }
  try
  {
    writeResult(options, written, files);
  }
  catch (const std::bad_alloc&)
  {
    written.result = outOfMemory(options.surface);
    written.files.clear();
    files.abandon();
    writeRefusal(options, written.result, files);
  }
  return written;
}
}
