// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"

#include "Batch.h"
#include "Check.h"
#include "CommandLine.h"
#include "FlattenToFiles.h"
#include "InputError.h"
#include "Listings.h"
#include "Make.h"
#include "Options.h"
#include "PlainText.h"
#include "Progress.h"
#include "Resewing.h"
#include "Table.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace
{
using namespace wirewarp;

/// Throws InputError where what was printed did not arrive.
void finishOutput()
{
  errno = 0;
  std::cout.flush();
  if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
  {
    return;
  }
  const std::string reason = errno != 0 ? std::generic_category().message(errno) : "";
  throw InputError("standard output",
    "cannot be written" + (reason.empty() ? "" : " (" + reason + ")") +
      "; send it elsewhere, or leave the table out with --quiet");
}

/// Ends the program without the destructors of libraries: under a limit of memory OpenBLAS waits
/// there for a thread that tries for ever to get its own.
[[noreturn]] void leave(int exitCode)
{
#if defined(__SANITIZE_ADDRESS__) || defined(_WIN32)
  std::exit(exitCode); // which looks for leaks
#else
  std::quick_exit(exitCode);
#endif
}

/// The files by their folders.
std::string writtenFiles(const std::vector<std::string>& files)
{
  std::string text;
  std::string before = "?";
  for (const std::string& file : files)
  {
    const std::filesystem::path path = std::filesystem::u8path(file);
    const std::string folder = path.parent_path().string();
    text += folder == before ? ", "
                             : (text.empty() ? "" : "\n") + std::string("written") +
        (folder.empty() ? "" : " to " + plainText(folder)) + ": ";
    text += plainText(path.filename().string());
    before = folder;
  }
  return text + (text.empty() ? "" : "\n");
}

/// On a terminal, unless its user wants no colors.
void sayInRed(const std::string& text)
{
  const bool red = stderrIsTerminal() && !std::getenv("NO_COLOR") && !text.empty();
  std::cerr << (red ? "\033[31m" : "") << text << (red ? "\033[0m" : "");
}

void say(const Options& options, const FilesOfFlattening& written)
{
  if (options.table)
  {
    std::cout << pieceTable(written.result) << '\n' << curveTable(written.result) << '\n';
  }
  std::cout << verdicts(written.result) << curveDistance(written.result)
            << fallbacks(written.result) << releaseAdvice(written.result)
            << suggestionTable(written.result, options.table) << reshapingTable(written.result)
            << resewingTable(options.resewing.text("Test") == "product", written.result)
            << keyPriceTable(written.result) << writtenFiles(written.files);
}

int run(const Options& options)
{
  if (options.command == "materials")
  {
    printMaterials(std::cout);
    return Done;
  }
  if (options.command == "formats")
  {
    printFormats(std::cout);
    return Done;
  }
  if (options.command == "check")
  {
    return runCheck(options);
  }
  if (!options.batch.empty())
  {
    return runBatch(options);
  }
  checkPicture(options.picture);
  const FilesOfFlattening written = flattenToFiles(options);
  if (written.result.refused())
  {
    std::cerr << messageLine("error", written.result.message);
    return written.result.exitCode;
  }
  if (!options.quiet && options.command == "make" && !options.table)
  {
    std::cout << summaryOfMaking(options, written);
  }
  else if (!options.quiet)
  {
    say(options, written);
  }
  std::cout.flush();
  std::cerr << (options.quiet ? "" : unitNote(written.result)) << writeErrors(written.result)
            << warnings(written.result);
  if (written.result.exitCode == Flawed)
  {
    sayInRed(pieceWarnings(written.result));
  }
  return written.result.outcome();
}
}

void wirewarp::runCommand(int argc, char** argv)
{
  // Then a file beyond the limit of the shell fails like one on a full disk.
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  int exitCode = Done;
  try
  {
    if (const std::optional<Options> options = parseCommandLine(argc, argv, exitCode))
    {
      exitCode = run(*options);
    }
    finishOutput();
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << messageLine(
      "error", std::string("OutOfMemory: memory ran out; ") + wayOutOfMemory);
    exitCode = InputRefused;
  }
  catch (const std::exception& error)
  {
    std::cerr << messageLine("error", error.what());
    exitCode = InputRefused;
  }
  leave(exitCode);
}
