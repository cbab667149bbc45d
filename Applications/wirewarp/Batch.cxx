// SPDX-License-Identifier: BSD-3-Clause
#include "Batch.h"

#include "FlattenToFiles.h"
#include "InputError.h"
#include "Options.h"
#include "OutputFiles.h"
#include "OutputPaths.h"
#include "PlainText.h"
#include "Progress.h"
#include "Table.h"
#include "TextFile.h"
#include "WorkerProcesses.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace wirewarp
{
namespace
{
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

constexpr const char* batchName = "batch.json";

/// One surface of a list and the folder of its files.
struct BatchEntry
{
  std::string surface;
  std::vector<std::string> curves;
  std::string folder; ///< in the output folder: the surface's name, numbered where it comes again
};

/// The next name off the front of a line; empty at its end or at a comment.
std::string takeEntry(std::string_view& rest, const LineReader& lines)
{
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t\v\f"), rest.size()));
  if (rest.empty() || rest.front() == '#')
  {
    return "";
  }
  const std::optional<std::string> name = takeName(rest);
  if (!name || name->empty())
  {
    lines.refuse("a name in quotes has no end or is empty; write \"a name\"");
  }
  return *name;
}

/// Reads a list of surfaces, one a line with its files of curves: words divided by blanks, in
/// double quotes where a name holds blanks; '#' starts a comment. Throws InputError.
std::vector<BatchEntry> readBatch(const std::string& path)
{
  const std::string text = readWholeFile(path);
  LineReader lines(path, text);
  std::set<std::string> taken{ batchName };
  std::vector<BatchEntry> entries;
  std::string line;
  while (lines.next(line))
  {
    std::string_view rest(line);
    BatchEntry entry;
    entry.surface = takeEntry(rest, lines);
    if (entry.surface.empty())
    {
      continue;
    }
    for (std::string name = takeEntry(rest, lines); !name.empty(); name = takeEntry(rest, lines))
    {
      entry.curves.push_back(std::move(name));
    }
    const std::string stem = std::filesystem::u8path(entry.surface).stem().string();
    if (stem.empty() || stem == "." || stem == "..") // its folder would be none of its own
    {
      lines.refuse(inQuotes(entry.surface) + " is not the name of a file");
    }
    entry.folder = stem;
    for (int copy = 2; !taken.insert(entry.folder).second; ++copy)
    {
      entry.folder = stem + "_" + std::to_string(copy);
    }
    entries.push_back(std::move(entry));
  }
  if (entries.empty())
  {
    throw InputError(path, "names no surface; write SURFACE [CURVES...], one surface a line");
  }
  return entries;
}

Options optionsOf(const Options& options, const BatchEntry& entry)
{
  Options one = options;
  one.surface = entry.surface;
  one.curves = entry.curves;
  const std::filesystem::path folder =
    std::filesystem::u8path(options.output) / std::filesystem::u8path(entry.folder);
  one.command = options.batchCommand;
  one.outputs = { folder.string() };
  for (const std::string& file : options.batchOutputs)
  {
    one.outputs.push_back((folder / std::filesystem::u8path(file)).string());
  }
  one.output.clear();
  one.batch.clear();
  resolveOutputs(one);
  one.quiet = true; // no progress within a surface
  return one;
}

/// No result of one surface may replace what another is read from.
void checkInputs(const Options& options, const std::vector<BatchEntry>& entries)
{
  InputFiles inputs;
  inputs.add(options.batch);
  for (const BatchEntry& entry : entries)
  {
    inputs.add(entry.surface);
    for (const std::string& path : entry.curves)
    {
      inputs.add(path);
    }
  }
  inputs.refuseToReplace(std::filesystem::u8path(options.output) / batchName, "--output");
  for (const BatchEntry& entry : entries)
  {
    refuseToReplaceInputs(inputs, optionsOf(options, entry));
  }
}

/// What became of one surface: its object in batch.json, and what to say on the terminal.
Json flattenEntry(const Options& options, const BatchEntry& entry)
{
  const Clock::time_point start = Clock::now();
  FilesOfFlattening written;
  Flattening& result = written.result;
  try
  {
    written = flattenToFiles(options);
  }
  catch (const std::exception& error)
  {
    result = {};
    result.exitCode = InputRefused;
    result.status = "UnwritableOutput";
    result.message = error.what();
  }
  std::string complaint = writeErrors(result) + warnings(result, entry.folder + ": ");
  if (result.refused())
  {
    complaint += messageLine("error", result.message);
  }
  else if (result.exitCode == Flawed)
  {
    complaint += pieceWarnings(result, entry.folder + ": ");
  }
  const double total = secondsSince(start);
  const double core = result.seconds.total;
  // What is neither reading nor flattening is writing, the report's own file included.
  const double write = result.refused() ? 0.0 : total - (result.secondsTotal - result.secondsWrite);
  const double filter = std::max(0.0, total - result.secondsRead - core - write);
  return { { "row",
             { { "surface", entry.surface }, { "curve_files", entry.curves },
               { "folder", entry.folder }, { "exit_code", result.outcome() },
               { "status", result.status }, { "message", result.message },
               { "unwritten", result.unwritten },
               { "triangles", result.refused() ? 0 : result.flat->faces.size() },
               { "seconds",
                 { { "read", result.secondsRead }, { "core", core }, { "filter", filter },
                   { "write", write }, { "total", total } } } } },
    { "note", result.refused() ? "" : unitNote(result, entry.folder + ": ") },
    { "complaint", complaint } };
}

/// Of a surface whose process died.
Json crashedEntry(const BatchEntry& entry)
{
  const std::string message = entry.surface +
    ": its process died; if memory ran out, try a smaller surface or fewer --threads";
  return { { "row",
             { { "surface", entry.surface }, { "curve_files", entry.curves },
               { "folder", entry.folder }, { "exit_code", InputRefused }, { "status", "Crashed" },
               { "message", message }, { "triangles", 0 },
               { "seconds",
                 { { "read", 0.0 }, { "core", 0.0 }, { "filter", 0.0 }, { "write", 0.0 },
                   { "total", 0.0 } } } } },
    { "note", "" }, { "complaint", messageLine("error", message) } };
}

void say(const Json& row)
{
  std::printf("%s: %s, %lld triangles, %.3f s\n",
    plainText(row["folder"].get<std::string>()).c_str(), row["status"].get<std::string>().c_str(),
    row["triangles"].get<long long>(), row["seconds"]["total"].get<double>());
  std::fflush(stdout);
}

// File names may hold any bytes; those that are no UTF-8 become replacement characters.
std::string textOf(const Json& json, int indent)
{
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}
}

int runBatch(const Options& options)
{
  const Clock::time_point start = Clock::now();
  const std::vector<BatchEntry> entries = readBatch(options.batch);
  const std::string& folder = options.output;
  checkInputs(options, entries);
  OutputFiles files;
  files.demandFolder(std::filesystem::u8path(folder));
  files.claim(std::filesystem::u8path(folder));
  const std::size_t threads = options.threads > 0
    ? static_cast<std::size_t>(options.threads)
    : std::max(1u, std::thread::hardware_concurrency());
  const std::size_t workers = std::min(threads, entries.size());
  const auto job = [&](std::size_t k) {
    // Threads within a surface only where there are more than surfaces.
    Options one = optionsOf(options, entries[k]);
    one.threads = static_cast<int>(threads / workers);
    return textOf(flattenEntry(one, entries[k]), -1);
  };
  std::vector<Json> rows(entries.size());
  const auto done = [&](std::size_t k, const std::optional<std::string>& text) {
    const Json outcome = text ? Json::parse(*text) : crashedEntry(entries[k]);
    rows[k] = outcome["row"];
    std::cerr << (options.quiet ? std::string() : outcome["note"].get<std::string>())
              << outcome["complaint"].get<std::string>();
    if (!options.quiet)
    {
      say(rows[k]);
    }
  };
  runInProcesses(entries.size(), workers, job, done);

  int exitCode = Done;
  for (const Json& row : rows)
  {
    const int code = row["exit_code"];
    // A refusal, without a result, is worse than a warning.
    exitCode =
      exitCode == InputRefused || code == InputRefused ? InputRefused : std::max(exitCode, code);
  }
  const double seconds = secondsSince(start);
  const double rate = static_cast<double>(entries.size()) / seconds;
  const Json report = { { "list", options.batch }, { "scheme", options.values.text("Scheme") },
    { "version", WIREWARP_VERSION }, { "exit_code", exitCode }, { "workers", workers },
    { "surfaces", rows }, { "seconds", seconds }, { "surfaces_per_second", rate } };
  files.add(std::filesystem::u8path(folder) / batchName, textOf(report, 2) + '\n');
  files.publish();
  if (!options.quiet)
  {
    std::printf(
      "%zu surface%s in %.2f s, %.3g a second; batch.json and one folder for each surface written "
      "to %s\n",
      entries.size(), entries.size() == 1 ? "" : "s", seconds, rate, plainText(folder).c_str());
  }
  return exitCode;
}
}
