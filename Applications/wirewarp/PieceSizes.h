// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace wirewarp
{
struct Flattening;

/// How large a flat piece is, and what whoever sews it has to do to its cloth.
struct PieceSize
{
  double width = 0.0;  ///< of its bounding box, mm
  double height = 0.0; ///< mm
  /// By how much the flat triangles are larger than those on the surface, which is cloth that must
  /// be eased in, and smaller, which is cloth that must be stretched: fractions of the surface's
  /// area.
  double easedIn = 0.0;
  double stretched = 0.0;
  /// The largest relative change of area of the triangles around one point, signed as flat minus
  /// surface; and where that is, in words.
  double worst = 0.0;
  std::string place;
};

/// Of each piece, in their order.
std::vector<PieceSize> pieceSizes(const Flattening& result);

/// A line a piece in words: size, what has to be eased in and where most.
/// \param unitAsked a warning says that the unit is not stated
std::string verdicts(const Flattening& result, bool unitAsked);

/// Of pieces that are hardly cut so small or large, since the unit may be another; empty for none.
std::string sizeWarning(const Flattening& result);
}
