// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "FaceSeams.h"
#include "FilterOptions.h"
#include "IdleOptions.h"
#include "Materials.h"
#include "MethodOptions.h"
#include "NearestOption.h"
#include "NumberOptions.h"
#include "PlainText.h"
#include "SuggestionOptions.h"
#include "TextFile.h"
#include "Units.h"

#include <vtkVersion.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
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
LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE or SPLINE, whose group or layer is called TYPE NAME; .csv
with the columns name, x, y, z and, unless names begin with it, type, an empty row between two of one name;
or text, one curve a line, '#' starts a comment, a NAME with blanks stands in double quotes:
    TYPE NAME v0 v1 ...
    edge NAME v0 v1 ...
TYPE is accessory (length kept), key (length and shape kept), straight (a key that is straight in the
plane: centre line, grainline, fold), dart (cut open) or seam (cut through);
edge is an accessory curve along the boundary, the shorter way from each vertex to the next: by its name a
hem or neckline has its own allowance and notches, and it stays a sew line of the pattern;
v0 v1 ... are vertex ids of SURFACE, counted from 0. Polylines in SURFACE itself are curves too. Points
of curves need not be vertices: they are laid on SURFACE if no farther from it than --imprint-tolerance.
Curves without a name are called "curve N", N counted from 0 over all curves. Where several share a
name, options that take a NAME mean all of them.

Units: lengths are in the unit of SURFACE, angles in radians, times in seconds; sizes are printed in mm and
cm, by --unit, or by what SURFACE or CURVES state (the field data LengthUnit of .vtp and .vtk, a comment
of OBJ such as "# units: mm"), or as if SURFACE were in cm. Files written to DIR keep a unit that is stated.
Pieces are numbered from 1 where they are read of; PieceId and "piece" of report.json count from 0.
Coordinates are read in double precision where the file holds them (STL holds single precision).

Files written to DIR: flat.vtp (pieces in the plane), wires.vtp (their wires), cut.vtp (the cut
surface in space, point for point like flat.vtp), report.json (all measures), and what is asked for of
pattern.svg, pattern.pdf, pattern.dxf, pattern.plt, pattern.json, walk.csv, lay.svg,
lay.plt; with --suggest also
curves.vtp (all curves), with --flattenable flattenable.vtp (the moved surface) and curves.vtp (the curves on
it), with --resew sewn.vtp (the cloth at rest, point for point like flat.vtp). Earlier ones are replaced,
and removed where a run writes none of a kind; curves.vtp and flattenable.vtp stay. With --batch they are written to DIR/<name of SURFACE> for each surface, and the exit code is that of the worst.

Exit codes: 0 done; 2 bad usage; 3 input refused, no result, or files or the table cannot be written;
4 flattened, but a promise is broken (not converged, a length error above --max-length-error, a flipped
triangle, an overlap), or a given --bound is missed by more than half of it: files are written.

Example: wirewarp shirt_front.vtp shirt_front_curves.vtp --output shirt)";

/// Puts millimetres in place of a length that may have a unit; without a length 0.
std::string weldLength(std::string& text)
{
  const std::size_t end = text.find_first_not_of("+-.0123456789eE");
  const std::string_view unit =
    end == std::string::npos ? std::string_view("mm") : std::string_view(text).substr(end);
  double value = 0.0;
  const bool given = text != "true";
  if (given &&
    (!parseNumber(text.substr(0, end), value) || !(value >= 0.0) || unitNamed(unit).empty()))
  {
    return inQuotes(text) + " is not a length in mm; write a number from 0, as 0.05 or 0.05mm";
  }
  std::ostringstream millimetres;
  millimetres << std::setprecision(17) << value * millimetresOf(unitNamed(unit));
  text = millimetres.str();
  return "";
}

/// The arguments, with a length behind --weld as its value: a file behind it is none.
std::vector<std::string> argumentsOf(int argc, char** argv)
{
  std::vector<std::string> arguments;
  for (int k = 1; k < argc; ++k)
  {
    std::string next(argv[k]);
    const bool joins = !arguments.empty() && arguments.back() == "--weld" && next != "true" &&
      weldLength(next).empty();
    if (joins)
    {
      arguments.back() += '=' + next;
    }
    else
    {
      arguments.emplace_back(argv[k]);
    }
  }
  std::reverse(arguments.begin(), arguments.end()); // as CLI::App takes them
  return arguments;
}

void addMending(CLI::App& app, Options& options)
{
  const std::string group = "Mending SURFACE";
  app
    .add_flag("--weld", options.weld,
      "Join points of the boundary that lie on each other, as texture seams leave them, within a "
      "millionth of the size; with a length (--weld 0.05, --weld 0.05mm) those up to that "
      "distance apart")
    ->transform(CLI::Validator(weldLength, ""))
    ->group(group);
  app
    .add_option("--fill-holes", options.fillHoles,
      "Close openings up to so many millimetres across, where triangles are missing")
    ->check(number(std::numeric_limits<double>::min(), 1e9, "(0, 1e9]"))
    ->type_name("MM")
    ->group(group);
  app
    .add_flag("--outer-side", options.outerSide,
      "Of a closed sheet with thickness take the outer side alone: the larger one within its rim")
    ->group(group);
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

void addMaterials(CLI::App& app, Options& options)
{
  const std::string group = "Material";
  CLI::Option* const material = app.add_option("--material", options.material,
    "What the pieces are cut from: a name of --list-materials, or a JSON file with its numbers. "
    "isometric keeps the strain of its threads small and within its limits; other schemes only "
    "measure it");
  material->type_name("NAME|FILE")
    ->check(CLI::Validator(
      [](std::string& text) { return text.empty() ? std::string("it has no name") : ""; }, ""))
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--grain",
      [&options](const std::vector<std::string>& entries) {
        options.grain.clear();
        for (const std::string& entry : entries)
        {
          options.grain += (options.grain.empty() ? "" : ";") + entry;
        }
      },
      "How pieces lie on it: along a curve, or NAME:DEGREES at an angle from it (several times: "
      "each "
      "piece by the first that it has); by an angle from the upright of the piece (its first key "
      "curve, else its long side) to the warp, counter-clockwise; or free, where the material is "
      "strained least (default: 0)")
    ->type_name("CURVE|DEGREES|free")
    ->allow_extra_args(false)
    ->needs(material)
    ->group(group);
  app
    .add_flag_callback(
      "--list-materials",
      []() {
        printMaterials(std::cout);
        throw CLI::Success();
      },
      "Print the materials known by name with the sources of their numbers, and exit")
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
  CLI::Option* const surface = app.add_option("SURFACE", options.surface,
    "The surface: .vtp .vtk .obj .ply .stl .off .gltf .glb, of polygons or triangles");
  surface->type_name("");
  app
    .add_option(
      "CURVES", options.curves, "Files of feature curves: .vtp .vtk .obj .dxf .csv, or text")
    ->type_name("");
  addSeams(app, options);
  addMending(app, options);
  addMethods(app, options);
  addMaterials(app, options);
  addSuggestionOptions(app, options);
  addReshapingOptions(app, options.reshaping);
  addKeyPriceOptions(app, options);
  addResewingOptions(app, options.resewing);
  app
    .add_option("--body", options.body,
      "A surface that --resew's cloth does not go through and --flattenable does not enter, its "
      "normals outwards: a body, a last")
    ->type_name("FILE")
    ->group("Sewing again");
  addLayout(app, options);
  addLimits(app, options);
  addOutput(app, options);
  addPatternOptions(app, options.pattern);
  addSizeOptions(app, options.sizes);
  addPictureOptions(app, options.picture);
  app
    .add_option("--batch", options.batch,
      "Flatten many surfaces in one call: a file with SURFACE [CURVES...] on each line, names with "
      "blanks in double quotes. Each gets a folder of its name in DIR; batch.json there says what "
      "became of them and what took how long")
    ->type_name("LIST")
    ->excludes(surface, app.get_option("--pins"), app.get_option("--list-curves"),
      app.get_option("--picture"), app.get_option("--grade"))
    ->group("Input");

  exitCode = Done;
  try
  {
    app.parse(argumentsOf(argc, argv));
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
    const std::string fault =
      options.sizes.any() ? options.sizes.fault(options.pattern.size) : std::string();
    if (!fault.empty())
    {
      throw CLI::ValidationError(fault);
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
    std::cerr << "wirewarp: error: " << plainText(error.what())
              << plainText(nearestOption(app, app.remaining())) << "\nTry 'wirewarp --help'.\n";
    exitCode = BadUsage;
    return std::nullopt;
  }
  return options;
}
}
