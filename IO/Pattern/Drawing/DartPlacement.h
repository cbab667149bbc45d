// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/DrawingSource.h"

namespace flattening
{
namespace pattern
{
/// Where a folded dart is drawn: as it lies, or with its tips drawn back, where a sewn dart is to
/// end before the cut does. Its legs go with them by the affine map that leaves the mouth where it
/// is, so that straight legs stay straight and mirror images stay mirror images, of equal lengths.
class DartPlacement
{
public:
  /// \param loop on which the dart lies
  DartPlacement(const DrawingSource& all, const Indices& loop, const Dart& dart);

  /// How far its tips are to be drawn back, millimetres.
  double back() const { return this->Back; }
  /// From the tip to the middle of the mouth or to the other tip, before.
  double depth() const { return this->Depth; }
  /// InvalidOption where the tips would be drawn back by more than half of the depth.
  Status check(const std::string& dart, const std::string& piece) const;
  /// Draws a leg, whose length is then the one it has in the plane.
  void place(PatternLine& leg) const;
  /// Where a point of the legs, or between them, is drawn.
  Point2 at(const Point2& point) const;

private:
  double Back = 0.0;
  double Depth = 0.0;
  Point2 Middle = Point2::Zero();  ///< of the mouth, or between the tips
  Point2 Mouth = Point2::Zero();   ///< a way along it
  Point2 Inwards = Point2::Zero(); ///< from the middle towards the tip, of length 1
  bool TwoTips = false;
};
}
}
