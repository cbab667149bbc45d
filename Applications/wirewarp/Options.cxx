// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "FilterOptions.h"
#include "IdleOptions.h"
#include "PlainText.h"
#include "TextFile.h"

#include <vtkVersion.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <sstream>

namespace wirewarp
{
namespace
{
const char* const description =
  "Flattens a triangulated surface so that its boundary and its feature curves keep their length.\n"
  "Darts are opened and seams cut first; every piece is flattened on its own and laid beside the "
  "others.";

const char* const footer =
  R"(Curve files: .vtp or .vtk with polylines on the surface (cell arrays CurveType: 0 accessory, 1 key,
2 dart, 3 seam; CurveName; for more see vtkFeatureCurveAlgorithm); .obj with line elements, .dxf with
LINE, LWPOLYLINE or POLYLINE, whose group or layer is called TYPE NAME; .csv with the columns name, x, y, z
and, unless names begin with it, type; or text, one curve a line, '#' starts a comment:
    TYPE NAME v0 v1 ...
TYPE is accessory (length kept), key (length and shape kept), dart (cut open) or seam (cut through);
v0 v1 ... are vertex ids of SURFACE, counted from 0. Polylines in SURFACE itself are curves too. Points
of curves need not be vertices: they are laid on SURFACE if no farther from it than --imprint-tolerance.
Curves without a name are called "curve N", N counted from 0 over all curves. Where several share a
name, options that take a NAME mean all of them.

Units: lengths are in the unit of SURFACE, angles in radians, times in seconds.
Coordinates are read in double precision where the file holds them (STL holds single precision).

Files written to DIR: flat.vtp (pieces in the plane), wires.vtp (their wires), cut.vtp (the cut
surface in space, point for point like flat.vtp), report.json (all measures), and what is asked for of
pattern.svg, pattern.pdf, pattern.dxf; with --suggest also curves.vtp (all curves). Earlier ones are replaced. With --batch they are written to
DIR/<name of SURFACE> for each surface, and the exit code is that of the worst.

Exit codes: 0 done; 2 bad usage; 3 input refused, no result, or files or the table cannot be written;
4 flattened, but a promise is broken (not converged, a length error above --max-length-error, a flipped
triangle, an overlap): files are written.

Example: wirewarp shirt_front.vtp shirt_front_curves.vtp --output shirt)";

CLI::Validator number(double least, double most, const std::string& range)
{
  return CLI::Validator(
    [least, most, range](std::string& text) {
      double value = 0.0;
      const bool valid = parseNumber(text, value) && value >= least && value <= most;
      return valid ? std::string() : inQuotes(text) + " is not a number in " + range;
    },
    "in " + range);
}

CLI::Validator wholeNumber(long long least, long long most, const std::string& range)
{
  return CLI::Validator(
    [least, most, range](std::string& text) {
      long long value = 0;
      const bool valid = parseInteger(text, value) && value >= least && value <= most;
      return valid ? std::string() : inQuotes(text) + " is not a whole number " + range;
    },
    range);
}

void addPreference(const std::string& entry, std::map<std::string, double>& preferences)
{
  const std::size_t sign = entry.rfind('=');
  double value = 0.0;
  if (sign == std::string::npos || sign == 0 || !parseNumber(entry.substr(sign + 1), value) ||
    !std::isfinite(value) || value < 0.0)
  {
    throw CLI::ValidationError(
      "--prefer", inQuotes(entry) + " is not NAME=WEIGHT with a weight from 0");
  }
  preferences[entry.substr(0, sign)] = value;
}

void addTolerance(const std::string& entry, std::map<std::string, double>& tolerances)
{
  // The last sign, because a name may hold one.
  const std::size_t sign = entry.rfind('=');
  double value = 0.0;
  if (sign == std::string::npos || sign == 0 || !parseNumber(entry.substr(sign + 1), value) ||
    !(value >= 0.0 && value < 1.0))
  {
    throw CLI::ValidationError(
      "--tolerance", inQuotes(entry) + " is not NAME=FRACTION with a fraction in [0, 1)");
  }
  tolerances[entry.substr(0, sign)] = value;
}

void addMethods(CLI::App& app, Options& options)
{
  const std::string group = "Method";
  app
    .add_option("--scheme", options.scheme,
      "How the wires get their shape: isometric (wires and interior together), global (all angles "
      "together), progressive (patch by patch), lscm (for comparison: keeps no length)")
    ->check(CLI::IsMember({ "isometric", "global", "progressive", "lscm" }))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--solver", options.solver,
      "How the angles are solved for: newton (exact), sequential (the paper's). isometric only "
      "starts from that solution; not for lscm")
    ->check(CLI::IsMember({ "newton", "sequential" }))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--interior", options.interior,
      "How points between wires are placed: arap (as rigid as possible), laplacian, relaxation "
      "(the paper's iteration). isometric only starts there; not for lscm")
    ->check(CLI::IsMember({ "arap", "laplacian", "relaxation" }))
    ->capture_default_str()
    ->group(group);
  app
    .add_flag_callback(
      "--paper-method",
      [&options]() {
        options.scheme = "global";
        options.interior = "laplacian";
      },
      "The paper's method: --scheme global --interior laplacian. newton finds the minimum that the "
      "paper asks for; --solver sequential goes there by the paper's steps, where they converge")
    ->excludes("--scheme", "--interior")
    ->group(group);
  app.add_flag("--release-keys", options.releaseKeys, "Treat key curves as accessory curves")
    ->group(group);
  app
    .add_flag_callback(
      "--no-release-trials", [&options]() { options.releaseTrials = false; },
      "Do not try what a release would bring where a piece lies poorly, which takes up to six "
      "flattenings of it; rank the curves to release by their sensitivity")
    ->group(group);
  app
    .add_flag("--close-cuts", options.closeCuts,
      "Close darts and other cuts as far as their banks would lie over each other")
    ->group(group);
  app
    .add_flag("--skip-closed", options.skipClosed,
      "Leave out pieces without boundary or with handles, which cannot be laid flat, and flatten "
      "the "
      "others; without it such a surface is refused")
    ->group(group);
  app
    .add_option("--energy", options.energy,
      "isometric: what deforming the sheet costs: rigid (as rigid as possible), dirichlet "
      "(symmetric Dirichlet, which forbids flipped triangles)")
    ->check(CLI::IsMember({ "rigid", "dirichlet" }))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--area-bias", options.areaBias,
      "isometric with rigid: above 0 a change of area costs more than one of angle (stiff sheet), "
      "below 0 less (stretchy sheet)")
    ->check(number(-0.99, 0.99, "[-0.99, 0.99]"))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--angle-weight", options.angleWeight,
      "isometric: weight of the wires' bending against the sheet")
    ->check(number(0.0, 100.0, "[0, 100]"))
    ->capture_default_str()
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--tolerance",
      [&options](const std::vector<std::string>& entries) {
        for (const std::string& entry : entries)
        {
          addTolerance(entry, options.tolerances);
        }
      },
      "Make a curve elastic: its length may change by up to this fraction, from 0 up to but not "
      "including 1; may be given several times")
    ->type_name("NAME=FRACTION")
    ->allow_extra_args(false)
    ->group(group);
  app
    .add_option("--pins", options.pins,
      "lscm: the two vertices that are pinned, ids counted from 0 (default: the boundary vertices "
      "farthest apart)")
    ->check(wholeNumber(0, std::numeric_limits<int>::max(), "from 0"))
    ->type_name("V0 V1")
    ->group(group);
}

void addSuggestions(CLI::App& app, Options& options)
{
  const std::string group = "Suggestions";
  CLI::Option* const suggest = app.add_option("--suggest", options.suggest,
    "Propose cuts with which the surface lies flat: darts, seams, or all; writes curves.vtp, all "
    "curves ready to be edited. Scheme and options are those of the flattening to come");
  suggest->check(CLI::IsMember({ "darts", "seams", "all" }))->group(group);
  app
    .add_option("--bound", options.bound,
      "The strain that is good enough, on 95 % of each piece's area; 0: cut until --max-cuts or "
      "--max-cut-length are used up")
    ->check(number(0.0, 0.99, "[0, 0.99]"))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app.add_option("--max-cuts", options.maximumCuts, "Most cuts to propose; a mirror image counts")
    ->check(wholeNumber(1, std::numeric_limits<int>::max(), "from 1"))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app
    .add_option("--max-cut-length", options.maximumCutLength,
      "Greatest length of all proposed cuts together, in the unit of SURFACE; 0: no limit")
    ->check(number(0.0, std::numeric_limits<double>::max(), "[0, inf)"))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app
    .add_option("--symmetric", options.symmetric,
      "auto: where the surface is its own mirror image so are the cuts")
    ->check(CLI::IsMember({ "auto", "off" }))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--prefer",
      [&options](const std::vector<std::string>& entries) {
        for (const std::string& entry : entries)
        {
          addPreference(entry, options.preferences);
        }
      },
      "How gladly a cut may begin or end on a curve: its price is divided by the weight; 0 forbids "
      "it; may be given several times")
    ->type_name("NAME=WEIGHT")
    ->allow_extra_args(false)
    ->needs(suggest)
    ->group(group);
}

void addLayout(CLI::App& app, Options& options)
{
  const std::string group = "Layout";
  app
    .add_flag_callback(
      "--no-arrange", [&options]() { options.arrange = false; },
      "Leave pieces where they arise instead of turning them upright, side by side")
    ->group(group);
  app
    .add_option("--spacing", options.spacing,
      "Space between the bounding boxes of pieces as a fraction of the largest side of one")
    ->check(number(0.0, 1e6, "[0, 1e6]"))
    ->capture_default_str()
    ->group(group);
}

void addLimits(CLI::App& app, Options& options)
{
  const std::string group = "Limits";
  const double large = std::numeric_limits<double>::max();
  const auto addNumber = [&app, &group](const std::string& name, double& value, double least,
                           double most, const std::string& range, const std::string& text) {
    app.add_option(name, value, text)
      ->check(number(least, most, range))
      ->capture_default_str()
      ->group(group);
  };
  const auto addCount = [&app, &group](
                          const std::string& name, int& value, int least, const std::string& text) {
    app.add_option(name, value, text)
      ->check(wholeNumber(least, std::numeric_limits<int>::max(), "from " + std::to_string(least)))
      ->capture_default_str()
      ->group(group);
  };
  addCount(
    "--max-iterations", options.maximumIterations, 1, "Most iterations of the solver, a piece");
  addNumber("--closure-tolerance", options.closureTolerance, 0.0, large, "[0, inf)",
    "The solver stops when no loop of wires is open by more than this fraction of the perimeter");
  addNumber("--optimality-tolerance", options.optimalityTolerance, 0.0, large, "[0, inf)",
    "The solver stops when no entry of the gradient of the Lagrangian is larger");
  addNumber("--max-length-error", options.maximumLengthError, 0.0, large, "[0, inf)",
    "Largest relative error of a wire edge that is no broken promise");
  addNumber("--relaxation-factor", options.relaxationFactor, std::numeric_limits<double>::min(),
    std::nextafter(2.0, 0.0), "(0, 2)", "relaxation: factor tau of the iteration");
  addNumber("--relaxation-movement", options.relaxationMovement, 0.0, large, "[0, inf)",
    "relaxation: stop when no point moves farther, as a fraction of the mean wire edge");
  addCount("--relaxation-min-iterations", options.relaxationMinimumIterations, 0,
    "relaxation: fewest iterations; more than --relaxation-max-iterations are refused");
  addCount("--relaxation-max-iterations", options.relaxationMaximumIterations, 1,
    "relaxation: most iterations");
  addNumber("--rigid-tolerance", options.rigidTolerance, 0.0, large, "[0, inf)",
    "arap: stop when the energy falls by less than this fraction of itself");
  addCount("--rigid-iterations", options.rigidMaximumIterations, 1, "arap: most iterations");
  addNumber("--isometric-tolerance", options.isometricTolerance, 0.0, large, "[0, inf)",
    "isometric: stop when the relative gradient of the Lagrangian is smaller");
  addCount(
    "--isometric-iterations", options.isometricMaximumIterations, 1, "isometric: most iterations");
  app
    .add_flag_callback(
      "--no-split", [&options]() { options.split = false; },
      "Refuse curves that do not run along mesh edges instead of splitting triangles")
    ->group(group);
  addNumber("--imprint-tolerance", options.imprintTolerance, 0.0, 1.0, "[0, 1]",
    "Greatest distance of a curve from the surface as a fraction of the surface's diagonal");
  addNumber("--snap-tolerance", options.snapTolerance, 0.0, 0.5, "[0, 0.5]",
    "A curve's point or crossing nearer to a vertex or an edge than this fraction of the mean edge "
    "length, or of the longest edge there where that is shorter, moves onto it");
}

void addOutput(CLI::App& app, Options& options)
{
  const std::string group = "Output";
  app
    .add_option("-o,--output", options.output,
      "Folder for the files, made if need be (default: <name of SURFACE or LIST>_flat in the "
      "current folder)")
    ->type_name("DIR")
    ->group(group);
  app
    .add_option("-t,--threads", options.threads,
      "Threads; 0: as many as there are cores. With --batch so many surfaces at a time. Results do "
      "not depend on it")
    ->check(wholeNumber(0, 1024, "from 0 to 1024"))
    ->capture_default_str()
    ->group(group);
  app
    .add_flag("--list-curves", options.listCurves, "Print the length of each feature curve as well")
    ->group(group);
  app.add_flag("-q,--quiet", options.quiet, "Print errors, warnings and broken promises only")
    ->group(group);
}
}

//------------------------------------------------------------------------------
std::string outputFolder(const Options& options)
{
  if (!options.output.empty())
  {
    return options.output;
  }
  const std::string& input = options.batch.empty() ? options.surface : options.batch;
  return std::filesystem::path(input).stem().string() + "_flat";
}

//------------------------------------------------------------------------------
std::optional<Options> parseCommandLine(int argc, char** argv, int& exitCode)
{
  Options options = defaultOptions();
  CLI::App app(description, "wirewarp");
  app.footer(footer);
  app.get_formatter()->column_width(34);
  std::ostringstream version;
  version << "wirewarp " << WIREWARP_VERSION << " (VTK " << vtkVersion::GetVTKVersion() << ')';
  app.set_version_flag("--version", version.str(), "Print the version and exit");
  CLI::Option* const surface = app.add_option(
    "SURFACE", options.surface, "The surface: .vtp .vtk .obj .ply .stl, of polygons or triangles");
  surface->type_name("");
  app.add_option("CURVES", options.curves, "Files of feature curves: .vtp .vtk, or text")
    ->type_name("");
  addMethods(app, options);
  addSuggestions(app, options);
  addLayout(app, options);
  addLimits(app, options);
  addOutput(app, options);
  addPatternOptions(app, options.pattern);
  addPictureOptions(app, options.picture);
  app
    .add_option("--batch", options.batch,
      "Flatten many surfaces in one call: a file with SURFACE [CURVES...] on each line, names with "
      "blanks in double quotes. Each gets a folder of its name in DIR; batch.json there says what "
      "became of them and what took how long")
    ->type_name("LIST")
    ->excludes(surface, app.get_option("--pins"), app.get_option("--list-curves"),
      app.get_option("--picture"))
    ->group("Input");

  exitCode = Done;
  try
  {
    app.parse(argc, argv);
    const std::string idle =
      idleOption(options, [&app](const std::string& option) { return app.count(option) > 0; });
    if (!idle.empty())
    {
      throw CLI::ValidationError(idle);
    }
    if (app.count("--output") > 0 && options.output.empty())
    {
      throw CLI::ValidationError("--output", "the folder has no name");
    }
    if (app.count("--batch") > 0)
    {
      if (options.batch.empty())
      {
        throw CLI::ValidationError("--batch", "the file has no name");
      }
    }
    else if (surface->count() == 0)
    {
      throw CLI::RequiredError("SURFACE");
    }
    else if (options.surface.empty())
    {
      throw CLI::ValidationError("SURFACE", "the file has no name");
    }
    if (options.pins[0] >= 0 && options.pins[0] == options.pins[1])
    {
      throw CLI::ValidationError("--pins", "the two vertices must differ");
    }
  }
  catch (const CLI::Success& request) // --help, --version
  {
    app.exit(request, std::cout, std::cerr);
    return std::nullopt;
  }
  catch (const CLI::ParseError& error)
  {
    std::cerr << "wirewarp: error: " << plainText(error.what()) << "\nTry 'wirewarp --help'.\n";
    exitCode = BadUsage;
    return std::nullopt;
  }
  return options;
}
}
