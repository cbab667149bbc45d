// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Display.h"
#include "Flattening.h"
#include "InputError.h"
#include "Options.h"
#include "OutputFiles.h"
#include "PatternPicture.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkPointData.h>

#include <CLI/CLI.hpp>

#include <filesystem>

namespace wirewarp
{
namespace
{
constexpr int pictureWidth = 1600;
constexpr int height = 1000;
constexpr int samples = 8;

std::vector<std::string> coloringNames()
{
  std::vector<std::string> names;
  for (const figures::Coloring coloring : figures::colorings)
  {
    names.emplace_back(figures::nameOf(coloring));
  }
  for (const figures::Coloring coloring : figures::threadColorings)
  {
    names.emplace_back(figures::nameOf(coloring));
  }
  names.emplace_back(figures::nameOf(figures::Coloring::Distance));
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

//------------------------------------------------------------------------------
void addFormerPictureOptions(CLI::App& app, PictureRequest& request)
{
  const std::string group = "Picture";
  app
    .add_option("--picture", request.path,
      "Write a picture: the cut surface and its flat pieces. Needs an X server (xvfb-run -a)")
    ->check(CLI::Validator(
      [](std::string& text) {
        return lowerCaseExtension(text) == ".png" ? std::string()
                                                  : inQuotes(text) + " does not end in .png";
      },
      "FILE.png"))
    ->group(group);
  app
    .add_option("--color-by", request.coloring,
      "What the picture's colours show: the surface's angle defects, or for each triangle what "
      "flattening does to its area (homogeneity, area) and its shape; with --material what its "
      "threads do: stretch (the largest, 100 to 120 %), warp, weft (strains), shear (trellis "
      "angle); with --resew distance: the sewn surface, coloured by how far it lies from the "
      "design, "
      "which is seen through")
    ->transform(CLI::IsMember(coloringNames(), CLI::ignore_case))
    ->capture_default_str()
    ->group(group);
}

//------------------------------------------------------------------------------
void addPicture(CLI::App& app, PictureRequest& request)
{
  app
    .add_option("--color", request.coloring,
      "What the colors show: developability (angle defects of the surface), homogeneity, area, "
      "aspect-ratio (what flattening does to triangles); with a material stretch, warp, weft, "
      "shear; with sewn pieces distance (from the surface)")
    ->transform(CLI::IsMember(coloringNames(), CLI::ignore_case).description(""))
    ->type_name("MEASURE")
    ->capture_default_str();
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
void addPicture(const Options& options, const Flattening& result, OutputFiles& files)
{
  figures::PatternScene scene;
  scene.piece = { result.flat, result.wires, result.cut };
  scene.coloring = figures::coloringOf(options.picture.coloring).value();
  scene.title = std::filesystem::path(options.surface).stem().string() + ", scheme " +
    options.values.text("Scheme");
  const std::string material = options.values.text("Material");
  if (!material.empty())
  {
    scene.title += ", " + std::filesystem::path(material).stem().string();
  }
  if (scene.coloring == figures::Coloring::Distance)
  {
    scene.sewn = result.sewn;
    scene.piece.flat = withDistance(result.flat, result.sewn);
    scene.title += ", sewn again (" + options.resewing.test + ")";
  }
  scene.warning = result.exitCode == PromiseBroken;
  scene.message = scene.warning ? result.message : "";
  const VtkMessages messages;
  figures::PatternPicture picture(pictureWidth, height, samples);
  picture.window()->SetOffScreenRendering(1);
  picture.show(scene);
  const auto write = [&picture](const std::string& path) {
    try
    {
      picture.write(path);
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
