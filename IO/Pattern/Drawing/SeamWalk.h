// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/DrawingSource.h"
#include "Outlines/Pattern.h"

#include <cmath>

namespace flattening::pattern
{
/// One interval of a seam or dart between two notches, or a notch and an end, as one who walks the
/// two sides along each other measures them. Lengths in millimetres, angles in degrees.
struct WalkInterval
{
  std::string join;       ///< its mark; empty: the legs of a folded dart
  double bend = 0.0;      ///< of the surface along the whole join, radians; see Join
  double thickness = 0.0; ///< of the material
  std::string curve;
  WireType type = WireType::Seam;
  std::array<std::size_t, 2> piece{}; ///< of the two sides
  int number = 1;                     ///< along the curve, from 1
  double from = 0.0;                  ///< along the curve, on the surface
  double to = 0.0;
  std::array<double, 2> length{}; ///< of the two sides, measured on what is drawn
  /// Sums of the angles that the cloth of both sides has at the start and at the end of the
  /// interval: 180 where what is sewn together runs on smoothly over the seam. At the tip of a dart
  /// both sides are one point, whose angle counts once.
  std::array<double, 2> angleSum{};

  /// How far the bevel of either side, of half the bend, goes back over the thickness, millimetres;
  /// below 0 where the surface is hollow.
  double bevel() const { return this->thickness * std::tan(this->bend / 2.0); }

  /// By how much the first side is longer than the second, in percent of that.
  double ease() const
  {
    return this->length[1] > 0.0 ? 100.0 * (this->length[0] / this->length[1] - 1.0) : 0.0;
  }
};

/// Walks all sides that are sewn to each other, in the order of the wires, along what is drawn.
/// \param all as prepareDrawing() gives it
std::vector<WalkInterval> walkSeams(const DrawingSource& all);

/// The walk as a table of comma-separated values: a head, and one row for each interval.
std::string makeWalkTable(const std::vector<WalkInterval>& walk, const Pattern& pattern);

/// The same for people to read: one row for each interval.
PatternTable walkRows(const std::vector<WalkInterval>& walk, const Pattern& pattern);

/// The joins of a walk by their marks, with their pieces and the lengths of both sides.
PatternTable joinRows(const std::vector<WalkInterval>& walk, const Pattern& pattern);
}
