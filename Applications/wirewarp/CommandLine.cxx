// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "FaceSeams.h"
#include "HelpFormatter.h"
#include "InputError.h"
#include "Make.h"
#include "OptionHints.h"
#include "OutputPaths.h"
#include "PlainText.h"
#include "Resewing.h"
#include "TableOptions.h"
#include "TextFile.h"
#include "Units.h"
#include "WriteData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>
#include <variant>
#include <vector>

namespace wirewarp
{
namespace
{
constexpr const char* expertGroup = "Options for experts";

/// Of --weld, which may be without a length.
CLI::Validator weldLength()
{
  const CLI::Validator lengths = length([](double value) { return value >= 0.0; }, "[0, inf)");
  return CLI::Validator(
    [lengths](std::string& text) {
      text = text == "true" ? "0" : text;
      return text == "false" ? std::string() : lengths(text);
    },
    "");
}

/// The arguments, with a length behind --weld as its value: a file behind it is none.
std::vector<std::string> argumentsOf(int argc, char** argv)
{
  std::vector<std::string> arguments;
  for (int k = 1; k < argc; ++k)
  {
    std::string next(argv[k]);
    const bool joins = !arguments.empty() && arguments.back() == "--weld" && next != "true" &&
      weldLength()(next).empty();
    if (joins)
    {
      arguments.back() += '=' + next;
    }
    else
    {
      arguments.emplace_back(argv[k]);
    }
  }
  return arguments;
}

/// Puts the name that the unit has here in place of another one of it, such as "CM" or "inches".
std::string unitWord(std::string& word)
{
  const std::string unit = unitNamed(word);
  if (unit.empty())
  {
    return inQuotes(word) + " is none of mm, cm, m, inch";
  }
  word = unit;
  return {};
}

void addMending(CLI::App& app, Options& options)
{
  const std::string group = "Mending SURFACE";
  app
    .add_flag("--weld,!--no-weld", options.weld,
      "Join points of the boundary that lie on each other, as texture seams leave them, within a "
      "millionth of the size; with a length (--weld 0.05, --weld 0.05mm) those up to that "
      "distance apart. cut and make do so where most of the boundary of an .obj or .ply lies on "
      "itself")
    ->transform(weldLength())
    ->group(group);
  app
    .add_option("--fill-holes", options.fillHoles,
      "Close openings of up to MM across, where triangles are missing")
    ->transform(length([](double value) { return value > 0.0 && value <= 1e9; }, "(0, 1e9]"))
    ->type_name("MM")
    ->group(group);
  app
    .add_flag("--outer-side,!--no-outer-side", options.outerSide,
      "Of closed sheets with thickness take the outer side alone: the larger one within its rim; "
      "of two-sided faces one. cut and make do so where a part is clearly such a sheet")
    ->group(group);
}

void addScaling(CLI::App& app, Options& options)
{
  app.add_option("--scale", options.scale, "Multiply the coordinates of SURFACE")
    ->check(number(1e-9, 1e9, "[1e-9, 1e9]"))
    ->type_name("FACTOR");
  app
    .add_option("--height", options.height,
      "Scale SURFACE to this height, such as 300mm, 1.7m or 12in. The height is along --up, else "
      "along y or z, the larger one; where no unit is stated the result is in mm")
    ->transform(length([](double value) { return value > 0.0 && value <= 1e9; }, "(0, 1e9]"))
    ->type_name("MM")
    ->excludes("--scale");
}

void addSeams(CLI::App& app, Options& options)
{
  static const std::map<std::string, SeamSource> sources{ { "uv", SeamSource::Textures },
    { "material", SeamSource::Materials }, { "group", SeamSource::Groups } };
  app
    .add_option("--seams-from", options.seamsFrom,
      "Cut an OBJ surface along the seams of its texture (uv), or where two materials (material), "
      "or two objects or groups (group) meet; pieces are named after objects or groups")
    ->transform(CLI::CheckedTransformer(sources, CLI::ignore_case).description(""))
    ->type_name("uv|material|group")
    ->group("Input");
}

void addGlobals(CLI::App& app, Options& options)
{
  const std::string group = globalGroup;
  app
    .add_option("--unit", options.unit,
      "Unit of SURFACE: mm, cm, m, inch (default: what the files state, or the likely one)")
    ->transform(CLI::Validator(unitWord, ""))
    ->type_name("mm|cm|m|inch")
    ->group(group);
  app
    .add_option("-t,--threads", options.threads,
      "Threads, which change no result (default, and 0: as many as there are cores)")
    ->check(wholeNumber(0, 1024, "from 0 to 1024"))
    ->type_name("N")
    ->group(group);
  app.add_flag("--table", options.table, "Print the numbers of pieces and curves")->group(group);
  app.add_flag("-q,--quiet", options.quiet, "Print errors and warnings alone")->group(group);
}

/// How a surface becomes flat, for every command that may be given one.
void addFlattening(CLI::App& app, Options& options)
{
  addSeams(app, options);
  app
    .add_option("--neutral-layer", options.neutralLayer,
      "Flatten the layer this far inside SURFACE, the neutral layer, whose lengths a bent sheet "
      "keeps. Where SURFACE is the outer face of a sheet it is 1 - K times its thickness, K the K "
      "factor (0.33 to 0.5); below 0 where SURFACE is the inner face")
    ->transform(length([](double value) { return std::abs(value) <= 1e6; }, "[-1e6, 1e6]"))
    ->type_name("MM");
  addMending(app, options);
  addMethods(app, options);
}

void addBody(CLI::App& app, Options& options)
{
  app
    .add_option("--body", options.body,
      "A surface, its normals outwards, that the result does not enter: a body, a shoe last")
    ->type_name("FILE");
}

void addList(CLI::App& app, Options& options)
{
  app
    .add_option("LIST", options.batch,
      "A file with SURFACE [CURVES...] on each line, names with blanks in double quotes")
    ->required()
    ->type_name("");
}

struct Command
{
  const char* name;
  const char* text;
  const char* operand;    ///< SURFACE, or SOURCE: a surface or a result; null: none
  const char* outputType; ///< null: it writes nothing
  const char* outputText;
  void (*addOwn)(CLI::App&, Options&);
  std::vector<const char*> shown; ///< options in its help; the others are in --help-all

  bool flattens() const { return this->outputType && std::string_view(this->name) != "check"; }
};

void declare(const Command& command, CLI::App& app, Options& options)
{
  if (command.operand)
  {
    app
      .add_option(command.operand, options.surface,
        command.operand == std::string_view("SURFACE")
          ? "The surface: .vtp .vtk .obj .ply .stl .off .gltf .glb"
          : "A surface, or the folder that 'wirewarp flatten' has written")
      ->type_name("");
  }
  if (command.operand && command.flattens())
  {
    app.add_option("CURVES", options.curves, "Feature curves: .vtp .vtk .obj .dxf .csv, or text")
      ->type_name("");
  }
  if (command.outputType)
  {
    app.add_option("-o,--output", options.outputs, command.outputText)
      ->type_name(command.outputType)
      ->allow_extra_args(false);
  }
  command.addOwn(app, options);
  if (command.flattens())
  {
    addFlattening(app, options);
  }
}

const std::vector<Command>& commands()
{
  constexpr auto nothing = [](CLI::App&, Options&) {};
  static const std::vector<Command> all{
    { "make", "Make a pattern of a surface in one go: check, propose cuts, flatten, draw",
      "SURFACE", "FILE|DIR",
      "File of the pattern: .pdf .svg .dxf .plt .json (GarmentCode) .csv (both sides of seams), or "
      ".vtp for the cuts; repeat it for the next. A folder keeps the result (default: <name of "
      "SURFACE>_pattern.pdf)",
      [](CLI::App& app, Options& options) {
        addMaking(app, options);
        addScaling(app, options);
        addCutting(app, options);
        addDrawing(app, options.pattern);
      },
      { "--for", "--template", "--height", "--max-strain", "--pieces", "--symmetric", "--effort",
        "--max-cuts", "--material", "--allowance", "--fold", "--pairs", "--paper", "--style" } },
    { "check", "Print size, likely unit, openings and defects of a surface; mend it", "SURFACE",
      "FILE", "Write the mended and scaled surface: .vtp",
      [](CLI::App& app, Options& options) {
        addMending(app, options);
        addScaling(app, options);
      },
      { "--weld", "--fill-holes", "--outer-side", "--scale", "--height" } },
    { "cut", "Propose darts and seams with which a surface lies flat, or lines on it", "SURFACE",
      "FILE|DIR",
      "File for the curves, .vtp (default: <name of SURFACE>_cuts.vtp); or a folder, which keeps "
      "the flat pieces as well",
      addCutting,
      { "--kind", "--max-strain", "--max-cuts", "--max-length", "--effort", "--pieces",
        "--max-width", "--symmetric", "--prefer", "--weights", "--material", "--grain",
        "--seams-from" } },
    { "flatten", "Flatten a surface so that boundary and curves keep their length", "SURFACE",
      "DIR", "The folder of the result (default: <name of SURFACE>_flat)", nothing,
      { "--material", "--grain", "--tolerance", "--ease", "--dart-legs", "--close-cuts",
        "--no-keys", "--skip-closed", "--seams-from", "--weld", "--scheme", "--paper-method" } },
    { "pattern", "Draw flat pieces as a pattern to cut: PDF, SVG, DXF, HPGL, GarmentCode", "SOURCE",
      "FILE|DIR",
      "File of the pattern: .pdf .svg .dxf .plt .json (GarmentCode) .csv (both sides of seams); "
      "repeat it for the next. A folder keeps the result (default: pattern.pdf)",
      [](CLI::App& app, Options& options) { addDrawing(app, options.pattern); },
      { "--allowance", "--notch-spacing", "--notch", "--double-notch", "--smooth", "--fold",
        "--pairs", "--dart-tip", "--piece", "--quantity", "--name", "--size", "--paper", "--style",
        "--seam-table" } },
    { "nest", "Lay all pieces on cloth of a width, as short as a search finds", "SOURCE",
      "FILE|DIR",
      "File of the lay: .svg or .plt (HPGL) (default: lay.svg); repeat it for the next. A folder "
      "keeps the result",
      [](CLI::App& app, Options& options) {
        addNesting(app, options.pattern);
        addDrawing(app, options.pattern);
      },
      { "--roll-width", "--nap", "--gap", "--quantity", "--piece", "--pairs", "--fold",
        "--allowance" } },
    { "grade", "Flatten a surface in several sizes and lay them on each other", nullptr, "FILE|DIR",
      "File of the sizes: .svg (all on each other) .csv (how far points go) .dxf .rul (rule "
      "table); repeat it for the next. A folder keeps the result of the base (default: nest.svg "
      "and rules.csv)",
      [](CLI::App& app, Options& options) {
        addSizes(app, options.curves, options.sizes, options.pattern.size);
        addDrawing(app, options.pattern);
      },
      { "--base", "--at", "--material", "--grain", "--scheme" } },
    { "sew", "Sew flat pieces together again: how far is that from the surface?", "SOURCE",
      "FILE|DIR",
      "File for the sewn shape, .vtp (default: sewn.vtp); or a folder, which keeps the result as "
      "well. The default is in SOURCE where that is a folder, or in <name of SURFACE>_sewn",
      [](CLI::App& app, Options& options) {
        addResewing(app, options.resewing);
        addBody(app, options);
      },
      { "--mode", "--body", "--gravity", "--pressure", "--thickness", "--once", "--material" } },
    { "reshape", "Move a surface as little as it takes to lie flat within a strain", "SURFACE",
      "FILE|DIR",
      "File for the moved surface, .vtp; or a folder, which keeps curves and flat pieces as well "
      "(default: <name of SURFACE>_reshaped)",
      [](CLI::App& app, Options& options) {
        addReshaping(app, options.reshaping);
        addBody(app, options);
      },
      { "--max-strain", "--keep", "--free-boundary", "--outward", "--body", "--material" } },
    { "picture", "Draw surface and flat pieces into a PNG file", "SOURCE", "FILE.png|DIR",
      "File for the picture (default: <name of SURFACE>.png, or picture.png in a folder)",
      [](CLI::App& app, Options& options) { addPicture(app, options.picture); },
      { "--color", "--color-range", "--material" } },
    { "prices", "Print what the planar shape of each key curve costs", "SURFACE", "DIR",
      "A folder that keeps the result with report.json", nothing, { "--material", "--scheme" } },
    { "batch", "Flatten the surfaces of a list, or run another command on each", nullptr, "DIR",
      "Folder of the results, one folder for each surface (default: <name of LIST>_flat)", addList,
      { "--material", "--grain", "--scheme", "--close-cuts", "--skip-closed", "--seams-from" } },
    { "materials", "Print the materials known by name with the sources of their numbers", nullptr,
      nullptr, nullptr, nothing, {} },
    { "formats", "Explain files of surfaces and curves, units and exit codes", nullptr, nullptr,
      nullptr, nothing, {} },
  };
  return all;
}

const Command* commandNamed(const std::string& name)
{
  for (const Command& command : commands())
  {
    if (name == command.name)
    {
      return &command;
    }
  }
  return nullptr;
}

constexpr const char* examples =
  R"(wirewarp SURFACE [CURVES...] is short for wirewarp flatten SURFACE [CURVES...].
wirewarp COMMAND --help lists the options of a command, --help-all those for experts as well.

  wirewarp make shirt.obj --for garment -o shirt.pdf
  wirewarp check shirt.obj
  wirewarp cut shirt.obj --kind darts -o curves.vtp
  wirewarp flatten shirt.obj curves.vtp -o shirt
  wirewarp pattern shirt -o shirt.pdf)";

/// Leaves what few need to --help-all.
void sortOptions(CLI::App& app, const std::vector<const char*>& shown)
{
  for (CLI::Option* const option : app.get_options())
  {
    if (option->get_positional())
    {
      continue;
    }
    const bool common = option->check_name("--output") || option == app.get_help_ptr() ||
      std::any_of(
        shown.begin(), shown.end(), [&](const char* name) { return option->check_name(name); });
    if (common || option->get_group() == commonGroup)
    {
      option->group(common ? commonGroup : expertGroup);
    }
  }
}

void addCommand(CLI::App& app, const Command& command, Options& options)
{
  app.set_help_flag("-h,--help", "Print these options; --help-all: those for experts as well");
  declare(command, app, options);
  sortOptions(app, command.shown);
  app.fallthrough();
  app.final_callback([&app, &options, &command]() {
    const bool nested = app.get_parent()->get_name() == "batch";
    (nested ? options.batchCommand : options.command) = command.name;
  });
}

/// The place of the word that is a command or a file: behind options of every command.
std::size_t firstWord(const std::vector<std::string>& arguments)
{
  static const std::set<std::string> withValue{ "--unit", "-t", "--threads" };
  static const std::set<std::string> flags{ "--table", "-q", "--quiet" };
  std::size_t k = 0;
  while (k < arguments.size() &&
    (flags.count(arguments[k]) > 0 || withValue.count(arguments[k]) > 0 ||
      arguments[k].rfind("--unit=", 0) == 0 || arguments[k].rfind("--threads=", 0) == 0))
  {
    k += withValue.count(arguments[k]) > 0 ? 2 : 1;
  }
  return std::min(k, arguments.size());
}

bool isGiven(const CLI::App& app, const std::string& option)
{
  const CLI::Option* const found = app.get_option_no_throw(option);
  return found && found->count() > 0;
}

/// Takes the words of `wirewarp grade` apart: sizes and curves.
void sortSizes(Options& options)
{
  std::vector<std::string> words;
  words.swap(options.curves);
  std::string& base = options.pattern.size;
  for (const std::string& word : words)
  {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos)
    {
      options.curves.push_back(word);
      continue;
    }
    const std::string name = word.substr(0, sign);
    base = base.empty() ? name : base;
    if (name == base && options.surface.empty())
    {
      options.surface = word.substr(sign + 1);
      options.sizes.texts.push_back(name);
    }
    else
    {
      options.sizes.texts.push_back(word);
    }
  }
  if (options.surface.empty() || options.sizes.texts.size() < 2)
  {
    throw CLI::ValidationError("name two sizes or more as SIZE=SURFACE" +
      (base.empty() ? std::string() : ", one of them the base " + inQuotes(base)));
  }
}

/// Accepts the folder of a result instead of a surface.
void takeSource(const CLI::App& app, Options& options)
{
  std::error_code ignored;
  if (!std::filesystem::is_directory(std::filesystem::u8path(options.surface), ignored) ||
    !app.get_option_no_throw("SOURCE"))
  {
    return;
  }
  options.source = options.surface;
  CLI::App flattening;
  Options unused = options;
  addFlattening(flattening, unused);
  const std::string lead = inQuotes(options.source) + " holds what is flattened already; ";
  if (!options.curves.empty())
  {
    throw CLI::ValidationError(lead + "leave out " + inQuotes(options.curves.front()));
  }
  for (const CLI::Option* const option : flattening.get_options())
  {
    const std::string name = option->get_name();
    if (name != "--help" && name != "--material" && isGiven(app, name))
    {
      throw CLI::ValidationError(
        std::string(lead).append("leave out ").append(name).append(", or name the surface"));
    }
  }
}

/// What is wrong with the first option that is given although it has no effect with the others;
/// empty: nothing. \param task with its output resolved
std::string idleOption(const CLI::App& app, const Options& task)
{
  const std::vector<PatternFile>& files = task.pattern.files;
  const bool drawsPdf = std::any_of(files.begin(), files.end(),
    [](const PatternFile& file) { return file.format == flattening::pattern::FileFormat::Pdf; });
  for (const char* const option : { "--paper", "--page-overlap", "--max-pages", "--seam-table" })
  {
    const bool isOfKind = task.command == "make" && std::string_view(option) == "--paper";
    if (isGiven(app, option) && !drawsPdf && !isOfKind)
    {
      return std::string(option) +
        " is for a pattern in PDF (-o FILE.pdf); give that as well, or leave it out";
    }
  }
  return describeIdleOption(task.values, flattening::OptionSpelling::Command);
}

/// Throws CLI::ParseError or InputError where what was given does not go together.
void checkOptions(const CLI::App& app, Options& options)
{
  const bool nested = app.get_parent()->get_name() == "batch";
  if (options.command == "grade")
  {
    sortSizes(options);
  }
  if (nested)
  {
    options.outputs = app.get_parent()->get_option("--output")->results();
    options.batchOutputs = app.get_option("--output")->results();
  }
  const bool batch = options.command == "batch";
  if (batch && options.batch.empty())
  {
    throw CLI::ValidationError("LIST", "the file has no name");
  }
  const bool prints = options.command == "materials" || options.command == "formats";
  if (!batch && !prints)
  {
    const char* const surface = app.get_option_no_throw("SOURCE") ? "SOURCE" : "SURFACE";
    if (options.surface.empty())
    {
      if (isGiven(app, surface))
      {
        throw CLI::ValidationError(surface, "the file has no name");
      }
      throw CLI::RequiredError(surface);
    }
    takeSource(app, options);
  }
  checkTemplate(options);
  const std::string fault =
    options.sizes.any() ? options.sizes.fault(options.pattern.size) : std::string();
  if (!fault.empty())
  {
    throw CLI::ValidationError(fault);
  }
  const auto& pins = std::get<std::vector<double>>(options.values["Pins"]);
  if (pins[0] >= 0.0 && pins[0] == pins[1])
  {
    throw CLI::ValidationError("--pins", "the two vertices must differ");
  }
  resolveOutputs(options);
  Options task = options; // of each surface
  if (nested)
  {
    task.command = options.batchCommand;
    task.outputs = options.batchOutputs;
    task.outputs.emplace_back("folder");
    task.output.clear();
    task.batch.clear();
    resolveOutputs(task);
  }
  static const std::set<std::string> keepLengths{ "cut", "make", "prices", "reshape" };
  if (options.values.text("Scheme") == "lscm" && keepLengths.count(task.command) > 0)
  {
    throw CLI::ValidationError(
      "--scheme", "lscm keeps no length; wirewarp " + task.command + " needs another scheme");
  }
  const std::string idle = idleOption(app, task);
  if (!idle.empty())
  {
    throw CLI::ValidationError(idle);
  }
}

/// What a batch may run: a flattening and all that reads one surface. Files of --output are named
/// within the folder of each surface.
void addCommandsOfBatch(CLI::App& batch, Options& options)
{
  static const std::set<std::string> left{ "make", "check", "grade", "batch", "materials",
    "formats" };
  for (const Command& command : commands())
  {
    if (left.count(command.name) > 0)
    {
      continue;
    }
    CLI::App* const sub = batch.add_subcommand(command.name, command.text)->group("Commands");
    addCommand(*sub, command, options);
    for (const char* const operand : { "SURFACE", "SOURCE", "CURVES" })
    {
      if (CLI::Option* const option = sub->get_option_no_throw(operand))
      {
        sub->remove_option(option);
      }
    }
  }
}

/// The command that a word is nearly, where it is the name of no file.
std::string commandMeantBy(const std::string& word)
{
  std::vector<std::string> names;
  for (const Command& command : commands())
  {
    names.emplace_back(command.name);
  }
  std::error_code ignored;
  const bool isFile = !lowerCaseExtension(word).empty() ||
    std::filesystem::exists(std::filesystem::u8path(word), ignored);
  return isFile ? "" : word == "help" ? "--help" : nearestWord(word, names);
}

/// The commands that have an option, "wirewarp pattern, wirewarp nest"; empty: none. That which
/// does the work of several is not listed.
std::string commandsWith(const std::string& option)
{
  std::string names;
  for (const Command& command : commands())
  {
    CLI::App app;
    Options unused;
    if (std::string_view(command.name) == "make" && option != "--for")
    {
      continue;
    }
    declare(command, app, unused);
    const CLI::Option* const found = app.get_option_no_throw(option);
    names += found && !found->get_lnames().empty()
      ? (names.empty() ? "wirewarp " : ", wirewarp ") + std::string(command.name)
      : "";
  }
  return names;
}

/// What is meant by the arguments that no option took, after a semicolon; empty where that is not
/// known.
std::string meantBy(const CLI::App& app, const std::vector<std::string>& unknown)
{
  for (const std::string& argument : unknown)
  {
    const std::string option = argument.substr(0, argument.find('='));
    if (const std::string successor = successorOf(option); !successor.empty())
    {
      return std::string("; ").append(option).append(" is now ").append(successor);
    }
    if (option.rfind("--", 0) == 0)
    {
      const std::string others = commandsWith(option);
      if (!others.empty())
      {
        return "; it is an option of " + others;
      }
    }
  }
  return nearestOption(app, unknown);
}
}

std::optional<Options> parseCommandLine(int argc, char** argv, int& exitCode)
{
  const auto refuse = [&exitCode](const std::string& fault, const std::string& command) {
    std::cerr << messageLine("error", fault) << "Try 'wirewarp " << command << "--help'.\n";
    exitCode = BadUsage;
    return std::nullopt;
  };
  Options options;
  std::vector<std::string> arguments = argumentsOf(argc, argv);
  const auto all = std::find(arguments.begin(), arguments.end(), "--help-all");
  const bool whole = all != arguments.end();
  if (whole)
  {
    *all = "--help";
  }
  const std::size_t first = firstWord(arguments);
  static const std::set<std::string> own{ "-h", "--help", "--version" };
  if (first < arguments.size() && !commandNamed(arguments[first]) &&
    own.count(arguments[first]) == 0)
  {
    const std::string meant = commandMeantBy(arguments[first]);
    if (!meant.empty())
    {
      return refuse(inQuotes(arguments[first]) +
          " is neither a command nor a file; did you mean wirewarp " + meant + "?",
        "");
    }
    arguments.insert(arguments.begin() + static_cast<std::ptrdiff_t>(first), "flatten");
  }

  if (first < arguments.size() && arguments[first] == "make")
  {
    arguments = withOptionsOfKind(arguments);
  }

  CLI::App app("Flattens triangulated surfaces into pieces whose boundary and feature curves keep "
               "their length.",
    "wirewarp");
  app.formatter(std::make_shared<HelpFormatter>(whole));
  app.footer(examples);
  app.set_help_flag("-h,--help", "Print this help and exit");
  std::ostringstream version;
  version << "wirewarp " << WIREWARP_VERSION << " (" << vtkInWords() << ')';
  app.set_version_flag("--version", version.str(), "Print the version and exit");
  addGlobals(app, options);
  app.require_subcommand(0, 1);
  const CLI::App* chosen = &app;
  for (const Command& command : commands())
  {
    CLI::App* const sub = app.add_subcommand(command.name, command.text)->group("Commands");
    sub->footer("wirewarp --help lists --unit, --threads, --table and --quiet.");
    if (first >= arguments.size() || arguments[first] != command.name)
    {
      continue;
    }
    chosen = sub;
    addCommand(*sub, command, options);
    if (std::string(command.name) == "batch")
    {
      sub->require_subcommand(0, 1);
      addCommandsOfBatch(*sub, options);
    }
  }

  exitCode = Done;
  try
  {
    std::reverse(arguments.begin(), arguments.end()); // as CLI::App takes them
    app.parse(arguments);
    if (chosen == &app)
    {
      throw CLI::RequiredError("COMMAND or SURFACE");
    }
    if (!chosen->get_subcommands().empty())
    {
      chosen = chosen->get_subcommands().front();
    }
    checkOptions(*chosen, options);
  }
  catch (const CLI::Success& request) // --help, --version
  {
    app.exit(request, std::cout, std::cerr);
    return std::nullopt;
  }
  catch (const InputError& error)
  {
    return refuse(error.what(), chosen->get_name() + ' ');
  }
  catch (const CLI::ParseError& error)
  {
    return refuse(error.what() + meantBy(*chosen, app.remaining()),
      chosen == &app ? "" : chosen->get_name() + ' ');
  }
  return options;
}
}
