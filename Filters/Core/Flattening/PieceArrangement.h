// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

namespace flattening
{
/// What the arrangement needs to know of a piece.
struct ArrangementPiece
{
  Points2 positions;
  /// Start and end of its grainline as indices of positions, {none, none} where there is none. The
  /// direction from start to end will point up.
  std::array<Index, 2> grain{ none, none };
  bool upright = false; ///< it stands as it is to stand
};

/// Turns each piece upright unless it is (its grainline, else the long side of its smallest
/// bounding rectangle, along y; of the two ways up then that with the first vertex off the middle
/// below it) and lays the pieces in rows beside each other, without overlap of their bounding
/// boxes, in their order. Only rigid motions without reflection; but for rounding the result does
/// not depend on where the pieces were.
/// \param spacing between bounding boxes, as a fraction of the largest side of one.
/// \return the new positions, per piece; the lower left corner of the first piece is the origin.
std::vector<Points2> arrangePieces(const std::vector<ArrangementPiece>& pieces, double spacing);

/// The nearest two parallel lines that points lie between.
struct LeastWidth
{
  double width = 0.0;
  Point2 across = Point2::UnitX(); ///< a unit vector
};
LeastWidth leastWidth(const Points2& points);

/// Of the convex hull. \pre all are finite
double hullArea(const Points2& points);

/// Points turned by an angle around the first of them, which comes to the origin: those far from it
/// keep their digits.
Points2 turnedAroundFirst(const Points2& points, double cosine, double sine);

/// Lower left corners of boxes of these sizes in such rows, the first at the origin.
std::vector<Point2> cornersInRows(const std::vector<Point2>& sizes, double spacing);
}
