// SPDX-License-Identifier: BSD-3-Clause
#include "Batch.h"
#include "FlattenToFiles.h"
#include "InputError.h"
#include "Options.h"
#include "Table.h"

#include <vtkSMPTools.h>

#include <iostream>
#include <optional>

namespace
{
using namespace wirewarp;

void say(const Options& options, const FilesOfFlattening& written)
{
  std::cout << pieceTable(written.result);
  std::cout << releaseAdvice(written.result);
  if (options.listCurves)
  {
    std::cout << '\n' << curveTable(written.result);
  }
  std::cout << '\n';
  for (const std::string& name : written.patterns)
  {
    std::cout << name << ", ";
  }
  std::cout << "flat.vtp, wires.vtp, cut.vtp and report.json written to " << written.folder << '\n';
  if (options.picture.any())
  {
    std::cout << "picture written to " << options.picture.path << '\n';
  }
}

int run(const Options& options)
{
  if (!options.batch.empty())
  {
    return runBatch(options);
  }
  if (options.threads > 0)
  {
    vtkSMPTools::Initialize(options.threads);
  }
  checkPicture(options.picture);
  const FilesOfFlattening written = flattenToFiles(options);
  if (written.result.refused())
  {
    std::cerr << "wirewarp: error: " << written.result.message << '\n';
    return written.result.exitCode;
  }
  if (!options.quiet)
  {
    say(options, written);
  }
  if (written.result.exitCode == PromiseBroken)
  {
    std::cout.flush();
    std::cerr << brokenPromises(written.result);
  }
  return written.result.exitCode;
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
