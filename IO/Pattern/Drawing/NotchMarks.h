// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/BorderMarks.h"

namespace flattening
{
namespace pattern
{
/// Draws the notches of one piece on its cut line.
class NotchMarks
{
public:
  /// All stay the caller's. \param cutLine complete before the first notch
  NotchMarks(const DrawingSource& all, const Segments& cutLine, PatternPiece& drawing)
    : All(all)
    , CutLine(cutLine)
    , Drawing(drawing)
  {
  }

  /// A notch where a way from the sew line meets the cut line.
  void add(const Point2& foot, const Point2& outward, double arcLength, const std::string& name);
  /// A mark across a leg of a dart, within the cloth.
  void addAcross(
    const Point2& foot, const Point2& outward, double arcLength, const std::string& name);
  /// Where sew lines meet at a corner, both go on to the cut line; into a corner of the cloth and
  /// where a curve ends goes one notch.
  void add(const BorderMark& mark);

private:
  /// Where a ray first meets the cut line; `from` where it does not.
  Point2 onCutLine(const Point2& from, const Point2& direction) const;

  const DrawingSource& All;
  const Segments& CutLine;
  PatternPiece& Drawing;
};
}
}
