// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"
#include "Flattening/FlatteningResult.h"

#include <string>
#include <vector>

namespace flattening
{
/// How large a flat piece is, and what whoever sews it has to do to its cloth.
struct PieceSize
{
  Point2 extent = Point2::Zero(); ///< of its bounding box, unit of length
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
std::vector<PieceSize> pieceSizes(const FlatteningResult& result);

/// Of pieces that are hardly cut so small or large, since the unit may be another; empty for none.
/// \param unit "mm", "cm", "m" or "inch"; empty where none is stated, and cm is taken
std::string sizeWarning(const std::vector<PieceSize>& sizes, const std::string& unit);

/// The names of pieces, numbered where several have one; empty where they have none.
/// \param cellNames a name for each triangle; empty: there are none
std::vector<std::string> pieceNames(
  const std::vector<std::string>& cellNames, const Indices& pieceOfTriangle, std::size_t pieces);

/// The size such as "51 x 55 cm", and what is to be eased in and stretched.
std::string sizeInWords(const PieceSize& size, double millimetres);
std::string easeInWords(const PieceSize& size);
}
