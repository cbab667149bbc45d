// SPDX-License-Identifier: BSD-3-Clause
#include "Make.h"

#include "FlattenToFiles.h"
#include "Flattening.h"
#include "Options.h"
#include "PlainText.h"
#include "Table.h"
#include "TriangleList.h"
#include "Units.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace wirewarp
{
namespace
{
struct DefaultOption
{
  std::string option;
  std::string value; ///< empty: a flag
};

/// What is made of a surface.
struct Kind
{
  std::string name;
  std::string text;
  std::vector<DefaultOption> defaults;
};

const std::vector<Kind>& kinds()
{
  static const std::vector<Kind> all{
    { "garment", "woven and knitted cloth: darts and seams", { { "--max-strain", "5%" } } },
    { "plush", "toys and covers", { { "--max-strain", "5%" }, { "--allowance", "6" } } },
    { "foam", "foam to glue edge on edge",
      { { "--kind", "seams" }, { "--max-strain", "5%" }, { "--material", "isotropic" },
        { "--cut-darts-out", "" }, { "--style", "cutter" } } },
    { "tent", "canvas and film, which hardly give",
      { { "--kind", "seams" }, { "--max-strain", "2%" }, { "--allowance", "15" },
        { "--paper", "sheet" }, { "--up", "none" } } },
    { "sheet", "metal, board and leather",
      { { "--max-strain", "1%" }, { "--material", "isotropic" }, { "--cut-darts-out", "" },
        { "--style", "cutter" } } },
  };
  return all;
}

/// What a template sets.
std::vector<DefaultOption> defaultsOfTemplate(const std::string& name)
{
  static const std::map<std::string, std::vector<DefaultOption>> all{
    { "front-back", { { "--kind", "darts" } } }, // the seams are there
    { "gores", { { "--kind", "gores" } } },
    { "foam-shell",
      { { "--kind", "seams" }, { "--material", "eva-foam" }, { "--neutral-layer", "2.5" },
        { "--cut-darts-out", "" } } },
  };
  const auto found = all.find(CLI::detail::to_lower(name));
  return found == all.end() ? std::vector<DefaultOption>() : found->second;
}

bool isOption(const std::string& argument, const std::string& option)
{
  return argument == option || argument.rfind(option + '=', 0) == 0;
}

bool hasOption(const std::vector<std::string>& arguments, const std::string& option)
{
  return std::any_of(arguments.begin(), arguments.end(),
    [&option](const std::string& argument) { return isOption(argument, option); });
}

/// The value of an option; without it the other one.
std::string valueIn(const std::vector<std::string>& arguments, const std::string& option,
  const std::string& otherwise)
{
  for (std::size_t k = 0; k < arguments.size(); ++k)
  {
    if (arguments[k] == option && k + 1 < arguments.size())
    {
      return arguments[k + 1];
    }
    if (isOption(arguments[k], option))
    {
      return arguments[k].substr(std::min(option.size() + 1, arguments[k].size()));
    }
  }
  return otherwise;
}

std::string counted(std::size_t count, const std::string& what)
{
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

std::string rounded(double value)
{
  std::ostringstream text;
  if (value >= 100.0)
  {
    text << std::fixed << std::setprecision(0) << value;
  }
  else
  {
    text << std::setprecision(3) << value;
  }
  return text.str();
}

std::string surfaceLine(const Options& options, const Flattening& result)
{
  const Point3 sizes = boxOf(*result.cut->points).sizes();
  return "surface: " + plainText(options.surface) + ", " + rounded(sizes.x()) + " x " +
    rounded(sizes.y()) + " x " + rounded(sizes.z()) + ' ' + result.unit +
    (result.unitStated ? "" : " (a likely unit; state it with --unit)") + '\n';
}

/// The row with the largest number of any of some columns.
std::size_t largestRow(const Table& pieces, const std::vector<const char*>& columns)
{
  std::size_t largest = 0;
  double most = -1.0;
  for (std::size_t row = 0; row < rowsOf(pieces); ++row)
  {
    for (const char* const column : columns)
    {
      if (numberIn(pieces, row, column) > most)
      {
        most = numberIn(pieces, row, column);
        largest = row;
      }
    }
  }
  return largest;
}

/// The row of a piece that covers itself, else of the one that is strained most.
std::size_t worstPiece(const Table& pieces)
{
  for (std::size_t row = 0; row < rowsOf(pieces); ++row)
  {
    if (coversItself(pieces, row))
    {
      return row;
    }
  }
  return largestRow(pieces, { "StrainP95" });
}

std::string cutsLine(const Options& options, const Flattening& result)
{
  const Table cuts = suggestedCuts(result);
  std::map<std::string, std::size_t> count;
  double length = 0.0;
  for (std::size_t row = 0; row < rowsOf(cuts); ++row)
  {
    ++count[textIn(cuts, row, "Type")];
    length += numberIn(cuts, row, "Length");
  }
  std::string text;
  for (const auto& [type, number] : count)
  {
    text += counted(number, type) + ", ";
  }
  const bool mirrored =
    !mirrorNumbers(result, "MirrorPlane").empty() || !mirrorNumbers(result, "MirrorAxis").empty();
  const bool strained = rowsOf(result.search) > 0 &&
    numberIn(result.search, 0, "StrainAfter") > options.values.number("Bound");
  const Table& pieces = result.tables.pieces;
  const bool enough =
    !strained && (rowsOf(pieces) == 0 || !coversItself(pieces, worstPiece(pieces)));
  return text.empty() ? (enough ? "cuts: none are needed\n" : "cuts: none that help are found\n")
                      : "cuts: " + text + rounded(length) + ' ' + result.unit + " long in all" +
      (mirrored ? ", mirrored\n" : "\n");
}

std::string piecesLine(const Flattening& result)
{
  const Table& pieces = result.tables.pieces;
  const std::size_t largest = largestRow(pieces, { "FlatWidth", "FlatHeight" });
  return "pieces: " + std::to_string(rowsOf(pieces)) + ", the " +
    (rowsOf(pieces) > 1 ? "longest " : "size ") + textIn(pieces, largest, "SizeInWords") + '\n';
}

std::string fitLine(const Options& options, const Flattening& result)
{
  const Table& pieces = result.tables.pieces;
  const std::size_t worst = worstPiece(pieces);
  const std::string piece =
    rowsOf(pieces) > 1 ? "on piece " + std::to_string(worst + 1) + ", " : "";
  const std::string place = textIn(pieces, worst, "WorstPlace");
  return "fit: " + fitVerdict(pieces, worst, options.values.number("Bound")) +
    (place.empty() ? "" : ", worst " + piece + plainText(place)) + '\n';
}

std::string filesLine(const Options& options, const FilesOfFlattening& written)
{
  std::string text;
  for (const std::string& file : written.files)
  {
    text += (text.empty() ? "open: " : ", ") + plainText(file);
  }
  const std::vector<PatternFile>& files = options.pattern.files;
  const bool printed = std::any_of(files.begin(), files.end(),
    [](const PatternFile& file) { return file.format == flattening::pattern::FileFormat::Pdf; });
  return text.empty()
    ? ""
    : text + (printed ? "; print at 100 % and measure the rectangle of 100 mm x 50 mm\n" : "\n");
}
}

void addMaking(CLI::App& app, Options& options)
{
  std::vector<std::string> names;
  std::string words;
  std::string text = "Options that are not given are then:";
  for (const Kind& kind : kinds())
  {
    names.push_back(kind.name);
    words += (words.empty() ? "" : "|") + kind.name;
    std::string line = "\n  " + kind.name;
    line.append(" (").append(kind.text).append("):");
    for (const DefaultOption& option : kind.defaults)
    {
      line.append(" ").append(option.option);
      line.append(option.value.empty() ? "" : " ").append(option.value);
    }
    text += line;
  }
  app.add_option("--for", options.madeFor, "What is made, which sets options that are not given")
    ->transform(CLI::IsMember(names, CLI::ignore_case).description(""))
    ->type_name(words)
    ->default_str(names.front());
  app
    .add_option("--template", options.seams,
      "Seams: front-back, gores, strips (by --max-width), foam-shell. Front-back: where the plane "
      "between both cuts the surface, and darts where they are needed; gores: of a round surface, "
      "as many as --pieces or the fewest within the bound; strips: none wider than --max-width "
      "with its allowances; "
      "foam-shell: seams alone, drawn for the middle of eva-foam 5 mm thick inside the surface "
      "(--neutral-layer)")
    ->transform(CLI::IsMember({ "front-back", "gores", "strips", "foam-shell" }, CLI::ignore_case)
                  .description(""))
    ->type_name("TEMPLATE");
  app.footer(text + "\n\n" + app.get_footer());
}

void checkTemplate(const Options& options)
{
  if (options.seams == "strips" && options.values.number("MaximumWidth") <= 0.0)
  {
    throw CLI::ValidationError(
      "--template", "strips needs --max-width, the width of the roll, such as --max-width 1.5m");
  }
}

std::vector<std::string> withOptionsOfKind(std::vector<std::string> arguments)
{
  const std::string name = valueIn(arguments, "--for", kinds().front().name);
  std::vector<DefaultOption> defaults = defaultsOfTemplate(valueIn(arguments, "--template", ""));
  for (const Kind& kind : kinds())
  {
    if (CLI::detail::to_lower(name) == kind.name)
    {
      defaults.insert(defaults.end(), kind.defaults.begin(), kind.defaults.end());
    }
  }
  const std::vector<std::string> given = arguments;
  for (const DefaultOption& option : defaults)
  {
    if (!hasOption(given, option.option) && !hasOption(arguments, option.option))
    {
      arguments.push_back(option.option + (option.value.empty() ? "" : '=' + option.value));
    }
  }
  return arguments;
}

std::string summaryOfMaking(const Options& options, const FilesOfFlattening& written)
{
  const Flattening& result = written.result;
  if (rowsOf(result.tables.pieces) == 0)
  {
    return filesLine(options, written);
  }
  return surfaceLine(options, result) + cutsLine(options, result) + piecesLine(result) +
    fitLine(options, result) + filesLine(options, written);
}
}
