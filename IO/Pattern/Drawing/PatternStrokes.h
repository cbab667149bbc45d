// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

#include <array>

namespace flattening::pattern
{
using Color = std::array<double, 3>;

/// How a kind of line looks on paper: in color it bears the color of its wire, in black and white
/// its dashes tell it apart.
struct StrokeStyle
{
  const char* name = ""; ///< as a class in SVG
  Color color{ 0.0, 0.0, 0.0 };
  double width = 0.25;            ///< millimetres
  std::array<double, 4> dashes{}; ///< millimetres on, off, on, off; 0 ends them
};

StrokeStyle styleOf(LineKind role);

/// A color of its own for each role, with every part 0, 1/2 or 1: programs of laser cutters choose
/// power, speed and order by color.
Color laserColor(LineKind role);

/// One line to draw, in the coordinates of its piece.
struct Stroke
{
  LineKind role = LineKind::Internal;
  bool closed = false;
  bool filled = false; ///< where lines have a width
  Points2 points;
  std::vector<FairSpan> smooth{}; ///< the same line as Bezier curves, where it is smooth
  std::string curve{};            ///< name of its feature curve
  double measure = 0.0;           ///< a wire's length on the surface, a notch's arc length
};

/// Everything of a piece but its texts, role by role.
std::vector<Stroke> strokesOf(const PatternPiece& piece);

/// As many of the first characters of a text as fit a width, with an ellipsis where it was cut.
std::string fitText(const std::string& text, double height, double width);
}
