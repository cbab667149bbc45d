// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

namespace flattening::pattern
{
/// Where the pieces lie on a sheet whose origin is its upper left corner, y down.
struct SheetLayout
{
  Points2 corners; ///< upper left corner of each piece
  Point2 extent = Point2::Zero();

  /// A point of a piece on the sheet.
  Point2 place(const Pattern& pattern, std::size_t piece, const Point2& p) const
  {
    return this->corners[piece] + Point2(p.x(), pattern.pieces[piece].extent.y() - p.y());
  }
};

/// Least distance of pieces on a sheet, millimetres.
constexpr double pieceGap = 15.0;

/// Lays the pieces in rows from the left, in their order, pieceGap apart and below `top`. No piece
/// is turned. A piece wider than `width` has a row of its own. Where they are laid on cloth they
/// stay as they are there, below `top`.
SheetLayout layOut(const Pattern& pattern, double width, double top);

/// A width that makes the sheet about as wide as high.
double squareWidth(const Pattern& pattern);
}
