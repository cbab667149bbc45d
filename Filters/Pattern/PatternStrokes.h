// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pattern.h"

#include <array>

namespace flattening
{
namespace pattern
{
/// How a kind of line looks on paper: in colour it bears the colour of its wire, in black and white
/// its dashes tell it apart.
struct StrokeStyle
{
  const char* name = ""; ///< as a class in SVG
  std::array<double, 3> colour{ 0.0, 0.0, 0.0 };
  double width = 0.25;            ///< millimetres
  std::array<double, 4> dashes{}; ///< millimetres on, off, on, off; 0 ends them
};

/// One line to draw, in the coordinates of its piece.
struct Stroke
{
  StrokeStyle style;
  bool closed = false;
  Points2 points;
  std::string curve;    ///< name of its feature curve
  double measure = 0.0; ///< a wire's length on the surface, a notch's arc length
  bool isWire = false;
  bool isNotch = false;
};

/// Everything of a piece but its texts, in the order of drawing.
std::vector<Stroke> strokesOf(const PatternPiece& piece);

/// As many of the first characters of a text as fit a width, with an ellipsis where it was cut.
std::string fitText(const std::string& text, double height, double width);
}
}
