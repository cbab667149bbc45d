// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Darts.h"

#include <limits>
#include <string>
#include <vector>

namespace flattening::pattern
{
/// A stretch of a seam or dart that is sewn to one other stretch. It ends where its curve ends,
/// where another piece begins on either side, and where the other side has a gap.
struct Join
{
  std::string mark;          ///< A, B, ..., Z, AA, ...; empty: the legs of a folded dart
  std::size_t wire = 0;      ///< of its first side
  std::size_t firstEdge = 0; ///< of the wire
  double from = 0.0;         ///< along the wire, on the surface, in the unit of the surface
  double to = 0.0;
  std::array<std::size_t, 2> piece{}; ///< of the sides
  std::array<Indices, 2> points;      ///< of the sides, in the direction of the curve
  /// The angle between the surfaces of both sides, radians, in the mean; above 0 where the surface
  /// is convex. Not a number where the surface is not known.
  double bend = std::numeric_limits<double>::quiet_NaN();
};

/// The mark of a join by its number from 0: A, ..., Z, AA, AB, ... without I and O, which look like
/// a notch and a hole.
std::string joinMark(std::size_t number);

/// All joins, in the order of the wires that are their first sides.
/// \param darts those that are folded, of all pieces by their loops
std::vector<Join> findJoins(const PatternSource& source, const BorderEdges& border,
  const SewnPartners& partners, const PieceLoops& loops,
  const std::vector<std::vector<Dart>>& darts);
}
