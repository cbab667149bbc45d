// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Display.h"
#include "Flattening.h"
#include "InputError.h"
#include "Options.h"
#include "OutputFiles.h"
#include "PatternPicture.h"
#include "PolyDataOutput.h"
#include "TableOptions.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace wirewarp
{
namespace
{
std::vector<std::string> coloringNames()
{
  using figures::Coloring;
  std::vector<std::string> names;
  for (const Coloring coloring : { Coloring::Strain, Coloring::Developability,
         Coloring::Homogeneity, Coloring::AspectRatio, Coloring::Area, Coloring::Stretch,
         Coloring::Warp, Coloring::Weft, Coloring::Shear, Coloring::Distance, Coloring::Piece })
  {
    names.emplace_back(figures::nameOf(coloring));
  }
  return names;
}

/// The flat pieces with what is known of the sewn surface, which is point for point like them.
figures::PolyData withDistance(const figures::PolyData& flat, const figures::PolyData& sewn)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(flat);
  result->GetPointData()->AddArray(sewn->GetPointData()->GetArray("Distance"));
  return result;
}
}

void addPicture(CLI::App& app, PictureRequest& request)
{
  app
    .add_option("--color", request.coloring,
      "What the colors show: strain (in %), homogeneity, area, aspect-ratio (what flattening does "
      "to triangles), developability (angle defects of the surface), piece (a color for each); "
      "with a material stretch, "
      "warp, weft, shear; with sewn pieces distance (from the surface)")
    ->transform(CLI::IsMember(coloringNames(), CLI::ignore_case).description(""))
    ->type_name("MEASURE")
    ->capture_default_str();
  app
    .add_option_function<std::vector<double>>(
      "--color-range,--range",
      [&request](const std::vector<double>& ends) {
        if (!(ends[0] < ends[1]))
        {
          throw CLI::ValidationError("--color-range", "the first number must be below the second");
        }
        request.range = { ends[0], ends[1] };
      },
      "Range of the colors, in the unit of their scale (default: by what is shown)")
    ->expected(2)
    ->check(number(-1e9, 1e9, "[-1e9, 1e9]"))
    ->type_name("LOW HIGH");
  app.add_option("--size", request.size, "Width and height of the picture, in pixels")
    ->check(CLI::Range(400, 10000).description(""))
    ->type_name("WIDTH HEIGHT")
    ->default_str("1600 1000");
}

void checkPicture(const PictureRequest& request)
{
  if (!request.any())
  {
    return;
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(request.path, ignored))
  {
    throw InputError(request.path, "is a folder; name a file with --output");
  }
  try
  {
    figures::requireDisplay();
  }
  catch (const std::runtime_error& error)
  {
    throw InputError(request.path, error.what());
  }
}

void addPicture(const Options& options, const Flattening& result, OutputFiles& files)
{
  const auto demand = [&](bool isThere, const char* what) {
    if (!isThere)
    {
      throw InputError(options.picture.path,
        "--color " + options.picture.coloring + " needs " + what + ", or choose another");
    }
  };
  const auto& threads = figures::threadColorings;
  figures::PatternScene scene;
  const figures::PolyData flat = polyDataOf(*result.flat);
  scene.piece = { flat, polyDataOf(*result.wires, flat->GetPoints()), polyDataOf(*result.cut),
    tableOf(result.tables.pieces), tableOf(result.tables.curves) };
  scene.coloring = figures::coloringOf(options.picture.coloring).value();
  scene.range = { options.picture.range[0], options.picture.range[1] };
  demand(scene.coloring != figures::Coloring::Distance || result.sewn != nullptr,
    "sewn pieces: run wirewarp sew on the result first");
  demand(std::find(threads.begin(), threads.end(), scene.coloring) == threads.end() ||
      findColumn(result.tables.pieces, "StrainWarpRms") != nullptr,
    "pieces of a material: flatten with --material");
  scene.title = std::filesystem::path(options.surface).stem().string() + ", scheme " +
    options.values.text("Scheme");
  const std::string material = options.values.text("Material");
  if (!material.empty())
  {
    scene.title += ", " + std::filesystem::path(material).stem().string();
  }
  if (scene.coloring == figures::Coloring::Distance)
  {
    scene.sewn = polyDataOf(*result.sewn);
    scene.piece.flat = withDistance(flat, scene.sewn);
    scene.title += ", sewn again";
  }
  scene.warning = result.exitCode == Flawed;
  scene.message = scene.warning ? result.message : "";
  const VtkMessages messages;
  const auto write = [&](const std::string& path) {
    try
    {
      const auto [width, height] = options.picture.size;
      figures::writePatternPicture(scene, width, height, path);
    }
    catch (const std::runtime_error&)
    {
      return std::string("cannot be written; name another file with --output");
    }
    return std::string();
  };
  const std::string problem = files.add(options.picture.path, write);
  if (!problem.empty())
  {
    throw InputError(options.picture.path, problem);
  }
}
}
