// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Coloring.h"
#include "Drawing.h"

#include <string>
#include <vector>

namespace figures
{
/// What a picture of a pattern shows.
struct PatternScene
{
  FlatPiece piece;
  PolyData sewn; ///< Coloring::Distance: output 0 of vtkSewnShape
  Coloring coloring = Coloring::Homogeneity;
  ColorRange range{ 0.0, 0.0 }; ///< of the colors; equal ends: by what is shown
  std::string title;
  std::string message; ///< what is amiss, or what to know; may have several lines
  bool warning = false;
};

/// Writes a PNG file with the surface in space on the left, its flat pieces on the right, and below
/// them the errors, the colors of the wires and the scale of the colors. Throws std::runtime_error.
void writePatternPicture(const PatternScene& scene, int width, int height, const std::string& path);

/// The largest and the least value that the colors show, on which piece and where on the surface,
/// and the mean by area.
std::string extremesOf(const FlatPiece& piece, const ColorMap& map);

/// One row of measures a piece, in columns of equal width, with a head.
std::vector<std::string> errorTable(const FlatPiece& piece, std::size_t maximumRows);
}
