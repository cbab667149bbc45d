// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening.h"
#include "InputError.h"
#include "Options.h"
#include "OutputFiles.h"
#include "Report.h"
#include "Table.h"

#include <vtkSMPTools.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <system_error>

namespace
{
using namespace wirewarp;

/// A pattern of an earlier run must not be cut for this one's.
void discardPatterns(const OutputFiles& files)
{
  for (const char* name : { "pattern.svg", "pattern.pdf", "pattern.dxf" })
  {
    files.discard(name);
  }
}

/// \return the names of the patterns among the files
std::vector<std::string> writeResult(
  const Options& options, const Flattening& result, OutputFiles& files)
{
  std::vector<std::string> patterns = addPatterns(options.pattern, options.surface, result, files);
  files.add("flat.vtp", result.flat);
  files.add("wires.vtp", result.wires);
  files.add("cut.vtp", result.cut);
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

int run(const Options& options)
{
  if (options.threads > 0)
  {
    vtkSMPTools::Initialize(options.threads);
  }
  checkPicture(options.picture);
  const std::string folder = outputFolder(options);
  std::error_code ignored;
  std::optional<OutputFiles> files; // a default folder is not made for a refusal alone
  if (!options.output.empty() || std::filesystem::is_directory(folder, ignored))
  {
    files.emplace(folder);
  }

  const Flattening result = flattenOne(options);
  if (result.refused())
  {
    std::cerr << "wirewarp: error: " << result.message << '\n';
    if (files)
    {
      writeRefusal(options, result, *files);
    }
    return result.exitCode;
  }

  if (!files)
  {
    files.emplace(folder);
  }
  std::optional<OutputFiles> picture;
  if (options.picture.any())
  {
    picture.emplace(options.picture.folder(), "--picture");
    addPicture(options, result, *picture);
  }
  const std::vector<std::string> patterns = writeResult(options, result, *files);
  if (picture)
  {
    picture->publish();
  }
  if (!options.quiet)
  {
    std::cout << pieceTable(result);
    std::cout << releaseAdvice(result);
    if (options.listCurves)
    {
      std::cout << '\n' << curveTable(result);
    }
    std::cout << '\n';
    for (const std::string& name : patterns)
    {
      std::cout << name << ", ";
    }
    std::cout << "flat.vtp, wires.vtp, cut.vtp and report.json written to " << folder << '\n';
    if (picture)
    {
      std::cout << "picture written to " << options.picture.path << '\n';
    }
  }
  if (result.exitCode == PromiseBroken)
  {
    std::cout.flush();
    std::cerr << brokenPromises(result);
  }
  return result.exitCode;
}
}

int main(int argc, char** argv)
{
  int exitCode = Done;
  try
  {
    if (const std::optional<Options> options = parseCommandLine(argc, argv, exitCode))
    {
      exitCode = run(*options);
    }
  }
  catch (const InputError& error)
  {
    std::cerr << "wirewarp: error: " << error.what() << '\n';
    exitCode = InputRefused;
  }
  catch (const std::exception& error)
  {
    std::cerr << "wirewarp: error: " << error.what()
              << "; if memory ran out, try a smaller surface\n";
    exitCode = InputRefused;
  }
  return exitCode;
}
