// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

namespace flattening
{
/// What the arrangement needs to know of a piece.
struct ArrangementPiece
{
  Points2 positions;
  /// Start and end of its grainline as indices of positions, {none, none} where there is none; the
  /// piece is turned so that the direction from start to end points up or, where the curve runs
  /// downwards on the surface, the caller has swapped them.
  std::array<Index, 2> grain{ none, none };
};

/// Turns each piece upright (its grainline, else the long side of its smallest bounding rectangle,
/// along y) and lays the pieces in rows beside each other, without overlap of their bounding boxes,
/// in their order. Only rigid motions without reflection; the result does not depend on where the
/// pieces were.
/// \param spacing between bounding boxes, as a fraction of the largest extent of a piece.
/// \return the new positions, per piece; the lower left corner of the first piece is the origin.
std::vector<Points2> arrangePieces(const std::vector<ArrangementPiece>& pieces, double spacing);
}
