// SPDX-License-Identifier: BSD-3-Clause
#include "OutputPaths.h"

#include "InputError.h"
#include "Options.h"
#include "TextFile.h"
#include "WriteData.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace wirewarp
{
namespace
{
namespace fs = std::filesystem;

/// Formats of patterns by endings of files.
using flattening::pattern::FileFormat;
using Formats = std::map<std::string, FileFormat>;

const std::map<std::string, Formats>& drawnFormats()
{
  static const Formats ofPatterns{ { ".pdf", FileFormat::Pdf }, { ".svg", FileFormat::Svg },
    { ".dxf", FileFormat::Dxf }, { ".plt", FileFormat::Hpgl }, { ".hpgl", FileFormat::Hpgl },
    { ".json", FileFormat::GarmentCode }, { ".csv", FileFormat::Walk } };
  static const std::map<std::string, Formats> all{
    { "make", ofPatterns },
    { "pattern", ofPatterns },
    { "nest",
      { { ".svg", FileFormat::Svg }, { ".plt", FileFormat::Hpgl },
        { ".hpgl", FileFormat::Hpgl } } },
    { "grade",
      { { ".svg", FileFormat::Nest }, { ".csv", FileFormat::GradeList },
        { ".dxf", FileFormat::Dxf }, { ".rul", FileFormat::RuleTable } } },
  };
  return all;
}

/// Whether surfaces and curves are written to files of an ending.
bool isData(const std::string& extension)
{
  return extension == ".vtp" || extension == ".obj";
}

/// The command that writes files of an ending; empty where none does.
std::string writerOf(const std::string& extension)
{
  if (extension == ".png")
  {
    return "picture";
  }
  if (isData(extension))
  {
    return "cut, sew and reshape";
  }
  for (const char* const command : { "pattern", "grade" })
  {
    if (drawnFormats().at(command).count(extension) > 0)
    {
      return command;
    }
  }
  return "";
}

/// Whether the command writes such a file, which is among the options then.
bool takeFile(Options& options, const std::string& path)
{
  const std::string extension = lowerCaseExtension(path);
  const std::string& command = options.command;
  const auto formats = drawnFormats().find(command);
  if (formats != drawnFormats().end() && formats->second.count(extension) > 0)
  {
    options.pattern.files.push_back({ path, formats->second.at(extension), command == "nest" });
    return true;
  }
  std::string* const file = extension == ".png" && command == "picture" ? &options.picture.path
    : !isData(extension)                                                ? nullptr
    : command == "cut" || command == "make"                             ? &options.curvesFile
    : command == "sew"                                                  ? &options.sewnFile
    : command == "reshape" || command == "check"                        ? &options.surfaceFile
                                                                        : nullptr;
  if (!file)
  {
    return false;
  }
  if (!file->empty())
  {
    throw InputError("--output names two files, " + inQuotes(*file) + " and " + inQuotes(path) +
      "; leave one of them out");
  }
  *file = path;
  return true;
}

/// What the command writes, by endings of files.
std::string endingsOf(const std::string& command)
{
  std::set<std::string> known{ ".obj", ".png", dataExtension };
  for (const auto& [name, formats] : drawnFormats())
  {
    for (const auto& [ending, format] : formats)
    {
      known.insert(ending);
    }
  }
  std::string endings;
  for (const std::string& ending : known)
  {
    Options options;
    options.command = command;
    endings += !takeFile(options, "file" + ending) ? "" : (endings.empty() ? "" : ", ") + ending;
  }
  return command == "check" ? endings : endings + (endings.empty() ? "a folder" : ", a folder");
}

/// Whether a name that is no folder's ends as those of files do: .txt, .jpeg, not .5 or .v2.
bool namesFile(const std::string& path)
{
  std::error_code ignored;
  const std::string extension = lowerCaseExtension(path);
  return extension.size() > 2 && extension.size() < 6 &&
    std::all_of(
      extension.begin() + 1, extension.end(), [](char one) { return one >= 'a' && one <= 'z'; }) &&
    !fs::is_directory(fs::u8path(path), ignored);
}

void takeFolder(Options& options, const std::string& path)
{
  const std::string writer = writerOf(lowerCaseExtension(path));
  if (options.command == "check" || (writer.empty() && namesFile(path)))
  {
    throw InputError("wirewarp " + options.command + " does not write " + inQuotes(path) +
      "; it writes " + endingsOf(options.command));
  }
  std::error_code ignored;
  if (!writer.empty() && !fs::is_directory(fs::u8path(path), ignored))
  {
    throw InputError("wirewarp " + options.command + " does not write " + inQuotes(path) +
      "; name a folder, or see wirewarp " + writer);
  }
  if (!options.source.empty() && options.command != "sew")
  {
    throw InputError("--output " + inQuotes(path) + ": the result is kept in " +
      inQuotes(options.source) + "; name a file");
  }
  if (!options.output.empty())
  {
    throw InputError("--output names two folders, " + inQuotes(options.output) + " and " +
      inQuotes(path) + "; leave one of them out");
  }
  options.output = path;
  options.outputGiven = true;
}

std::string stemOf(const Options& options)
{
  return fs::u8path(options.batch.empty() ? options.surface : options.batch).stem().string();
}

/// Default outputs, except for drawings.
void takeDefaults(Options& options)
{
  static const std::map<std::string, std::string> folders{ { "flatten", "_flat" },
    { "batch", "_flat" }, { "sew", "_sewn" }, { "reshape", "_reshaped" } };
  const auto folder = folders.find(options.command);
  if (options.command == "sew" && !options.source.empty())
  {
    options.sewnFile =
      (fs::u8path(options.source) / ("sewn" + std::string(dataExtension))).string();
  }
  else if (folder != folders.end())
  {
    options.output = stemOf(options) + folder->second;
  }
  else if (options.command == "cut")
  {
    options.curvesFile = stemOf(options) + "_cuts" + dataExtension;
  }
}

/// What the command draws that names no file for it: in its folder, or that of the source, or
/// beside the surface.
void takeDrawn(Options& options)
{
  static const std::map<std::string, std::vector<std::string>> drawn{ { "make", { "pattern.pdf" } },
    { "pattern", { "pattern.pdf" } }, { "nest", { "lay.svg" } },
    { "grade", { "nest.svg", "rules.csv" } }, { "picture", { "picture.png" } } };
  const auto names = drawn.find(options.command);
  if (names == drawn.end() || options.pattern.any() || options.picture.any())
  {
    return;
  }
  const fs::path folder = fs::u8path(options.output.empty() ? options.source : options.output);
  for (const std::string& name : names->second)
  {
    const std::string beside = name == "picture.png" ? ".png" : "_" + name;
    takeFile(
      options, folder.empty() ? stemOf(options) + beside : (folder / fs::u8path(name)).string());
  }
}
}

void resolveOutputs(Options& options)
{
  for (const std::string& path : options.outputs)
  {
    if (path.empty())
    {
      throw InputError("--output: the file or folder has no name");
    }
    if (!takeFile(options, path))
    {
      takeFolder(options, path);
    }
  }
  if (options.outputs.empty())
  {
    takeDefaults(options);
  }
  takeDrawn(options);
  if (!options.batch.empty()) // whose surfaces have files of their own
  {
    return;
  }
  const fs::path folder = fs::u8path(options.output);
  const auto within = [&](std::string& file, const std::string& name) {
    if (file.empty() && !folder.empty())
    {
      file = (folder / (name + dataExtension)).string();
    }
  };
  if (options.command == "cut" || options.command == "make" || options.command == "reshape")
  {
    within(options.curvesFile, "curves");
  }
  if (options.command == "reshape")
  {
    within(options.surfaceFile, "flattenable");
  }
  if (options.command == "sew")
  {
    within(options.sewnFile, "sewn");
  }
}
}
