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

#include <CLI/CLI.hpp>

#include <filesystem>

namespace wirewarp
{
namespace
{
constexpr int width = 1600;
constexpr int height = 1000;
constexpr int samples = 8;

std::vector<std::string> coloringNames()
{
  std::vector<std::string> names;
  for (const figures::Coloring coloring : figures::colorings)
  {
    names.emplace_back(figures::nameOf(coloring));
  }
  return names;
}
}

//------------------------------------------------------------------------------
std::string PictureRequest::folder() const
{
  const std::filesystem::path parent = std::filesystem::path(this->path).parent_path();
  return parent.empty() ? "." : parent.string();
}

//------------------------------------------------------------------------------
void addPictureOptions(CLI::App& app, PictureRequest& request)
{
  const std::string group = "Picture";
  app
    .add_option("--picture", request.path,
      "Write a picture: the cut surface and its flat pieces. Needs an X server (xvfb-run -a)")
    ->check(CLI::Validator(
      [](std::string& text) {
        return std::filesystem::path(text).extension() == ".png"
          ? std::string()
          : inQuotes(text) + " does not end in .png";
      },
      "FILE.png"))
    ->group(group);
  app
    .add_option("--color-by", request.coloring,
      "What the picture's colours show: the surface's angle defects, or for each triangle what "
      "flattening does to its area (homogeneity, area) and its shape")
    ->check(CLI::IsMember(coloringNames()))
    ->capture_default_str()
    ->group(group);
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
    throw InputError(request.path, "is a folder; name a file with --picture");
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
  scene.title =
    std::filesystem::path(options.surface).stem().string() + ", scheme " + options.scheme;
  scene.warning = result.exitCode == PromiseBroken;
  scene.message = scene.warning ? result.message : "";
  const VtkMessages messages;
  figures::PatternPicture picture(width, height, samples);
  picture.window()->SetOffScreenRendering(1);
  picture.show(scene);
  files.add(std::filesystem::path(options.picture.path).filename().string(),
    [&picture](const std::string& path) {
      try
      {
        picture.write(path);
      }
      catch (const std::runtime_error&)
      {
        return std::string("cannot be written; name another file with --picture");
      }
      return std::string();
    });
}
}
