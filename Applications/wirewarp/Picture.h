// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Flattening;
struct Options;
class OutputFiles;

/// The picture of the surface and its flat pieces.
struct PictureRequest
{
  std::string path; ///< empty: none is asked for
  std::string coloring = "strain";
  std::array<double, 2> range{};         ///< of the colors; equal: by what is shown
  std::array<int, 2> size{ 1600, 1000 }; ///< pixels

  bool any() const { return !this->path.empty(); }
};

void addPicture(CLI::App& app, PictureRequest& request);

/// Throws InputError where a picture is asked for and none can be drawn here.
void checkPicture(const PictureRequest& request);

/// Adds the picture to the files of its folder. Throws InputError.
void addPicture(const Options& options, const Flattening& result, OutputFiles& files);
}
