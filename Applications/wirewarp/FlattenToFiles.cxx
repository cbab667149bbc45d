// SPDX-License-Identifier: BSD-3-Clause
#include "FlattenToFiles.h"

#include "InputError.h"
#include "OutputFiles.h"
#include "Patterns.h"
#include "PlainText.h"
#include "Report.h"
#include "Sizes.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <iostream>
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
constexpr std::array<const char*, 11> allPatternNames{ "pattern.svg", "pattern.pdf", "pattern.dxf",
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
  for (const char* name : allPatternNames)
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

namespace
{
void demandPlaces(const Options& options, const OutputFiles& files)
{
  for (const char* name : dataNames)
  {
    files.demandPlace(name);
  }
  for (const PatternName& name : patternNames(options.pattern, options.sizes.any()))
  {
    files.demandPlace(name.file);
  }
  files.demandPlace(reportName);
}

/// Of a run that takes long: whether its pattern fits on cloth and paper, as the surface lies flat
/// without it. A refusal where that is out of the question; what proposed cuts may mend is warned
/// of.
Flattening rehearse(const Options& options, OutputFiles& files)
{
  Options plain = options;
  plain.suggest.clear();
  plain.reshaping = {};
  plain.resewing = {};
  plain.priceKeys = false;
  plain.picture = {};
  plain.quiet = true;
  plain.pattern = {};
  plain.pattern.unit = options.pattern.unit;
  PatternRequest layout = plain.pattern;
  layout.allowance = options.pattern.allowance;
  layout.fairTolerance = 0.0;
  layout.fabricWidth = options.pattern.fabricWidth;
  layout.paper = options.pattern.paper;
  layout.maximumPages = options.pattern.maximumPages;
  // A sheet that is too large for PDF may be divided.
  layout.pdf = options.pattern.pdf && (options.suggest.empty() || layout.paper != "sheet");
  const bool isLong = !options.suggest.empty() || options.reshaping.any() ||
    options.resewing.any() || options.priceKeys;
  Flattening trial;
  if (!isLong || !layout.any())
  {
    return trial;
  }
  trial = flattenOne(plain);
  if (trial.refused()) // closed surfaces, for example, which cuts open
  {
    return {};
  }
  const int pieces =
    options.suggest == "seams" || options.suggest == "all" ? options.maximumCuts + 1 : 1;
  const bool moves = !options.suggest.empty() || options.reshaping.any();
  const std::string problem = layoutProblem(layout, options.surface, 1, trial, files);
  Flattening refused;
  if (problem.empty())
  {
    return refused;
  }
  if (moves && layoutProblem(layout, options.surface, 2 * pieces, trial, files).empty())
  {
    std::cerr << "wirewarp: warning: before any cut, " << plainText(problem) << '\n';
    return refused;
  }
  refused.exitCode = InputRefused;
  refused.status = "PatternTooLarge";
  refused.message = options.surface + ": " + problem;
  return refused;
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
  for (const char* name : allPatternNames)
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
  std::optional<OutputFiles> picture;
  if (options.picture.any())
  {
    picture.emplace(options.picture.folder(), "--picture");
  }
  // Where files cannot be put is found before the work, which would be lost.
  std::error_code ignored;
  const bool existed = std::filesystem::exists(written.folder, ignored);
  OutputFiles files(written.folder);
  files.claim();
  demandPlaces(options, files);
  written.result = rehearse(options, files);
  if (!written.result.refused())
  {
    written.result = flattenOne(options);
  }
  if (options.sizes.any() && !written.result.refused())
  {
    gradeSizes(options, written.result);
  }
  if (written.result.refused())
  {
    if (existed || !options.output.empty())
    {
      writeRefusal(options, written.result, files);
    }
    else // a default folder is not made for a refusal alone
    {
      std::filesystem::remove(written.folder, ignored);
    }
    return written;
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
    written.patterns = writeResult(options, written.result, files);
    if (written.picture)
    {
      picture->publish();
    }
  }
  catch (const std::bad_alloc&)
  {
    written.result = outOfMemory(options.surface);
    files.abandon();
    writeRefusal(options, written.result, files);
  }
  return written;
}
}
