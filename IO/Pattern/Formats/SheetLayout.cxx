// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SheetLayout.h"

#include <algorithm>
#include <cmath>

namespace flattening::pattern
{
SheetLayout layOut(const Pattern& pattern, double width, double top)
{
  SheetLayout layout;
  if (pattern.fabric)
  {
    for (const Point2& corner : pattern.fabric->corners)
    {
      layout.corners.emplace_back(corner + Point2(0.0, top));
    }
    layout.extent = Point2(pattern.fabric->width, pattern.fabric->length + top);
    return layout;
  }
  Point2 at(0.0, top);
  double rowHeight = 0.0;
  for (const PatternPiece& piece : pattern.pieces)
  {
    if (at.x() > 0.0 && at.x() + piece.extent.x() > width)
    {
      at = Point2(0.0, at.y() + rowHeight + pieceGap);
      rowHeight = 0.0;
    }
    layout.corners.push_back(at);
    layout.extent = layout.extent.cwiseMax(at + piece.extent);
    at.x() += piece.extent.x() + pieceGap;
    rowHeight = std::max(rowHeight, piece.extent.y());
  }
  return layout;
}

double squareWidth(const Pattern& pattern)
{
  double area = 0.0;
  double widest = 0.0;
  for (const PatternPiece& piece : pattern.pieces)
  {
    area += piece.extent.prod();
    widest = std::max(widest, piece.extent.x());
  }
  return std::max(widest, 1.3 * std::sqrt(area));
}
}
