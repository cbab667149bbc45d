// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/DrawingSource.h"

namespace flattening::pattern
{
/// A place of a border that wants a notch whether or not it is sewn.
struct BorderMark
{
  std::size_t piece = 0;
  Index before = none; ///< the border's points around it
  Index point = none;
  Index after = none;
  bool corner = false;    ///< of the border; otherwise a curve meets it there
  std::string name;       ///< of that curve
  double arcLength = 0.0; ///< of the place along it, on the surface, in the unit of the surface
};

/// Corners, where the options ask for them, and where curves meet a border within its run: the ends
/// of feature curves, and the ends of seams and curves of the piece that is sewn to it there. Tips
/// and mouths of darts are neither: they have marks of their own.
std::vector<BorderMark> findBorderMarks(const DrawingSource& all);

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
