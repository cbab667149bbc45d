// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Planar.h"
#include "Paths/FlatTriangle.h"

namespace flattening
{
/// What straight lines from one foot reach of a triangle: a strip that leaves a leg of the path at
/// right angles, or a sector of less than pi from a corner. Places are those of the FlatTriangle,
/// those of feet outside of it in its plane unfolded.
struct OffsetWindow
{
  Index triangle = none;
  Index entered = none; ///< the side that it comes in by; none where it starts
  bool own = false;     ///< it starts on the side of the path that is asked for
  bool strip = false;
  Point2 apex = Point2::Zero(); ///< of a sector; the right end of a strip's leg
  double before = 0.0;          ///< length of the way from the path to the apex
  // Rays that bound it, seen from the foot.
  Point2 right = Point2::Zero();
  Point2 rightWay = Point2::Zero();
  Point2 left = Point2::Zero();
  Point2 leftWay = Point2::Zero();
  Point2 normal = Point2::Zero(); ///< which way a strip goes
  double reach = 0.0;             ///< how far the offset is from the apex, or the leg

  double besideRight(const Point2& p) const { return cross(this->rightWay, p - this->right); }
  double besideLeft(const Point2& p) const { return cross(p - this->left, this->leftWay); }
  /// How far a place is from the apex, or the leg.
  double away(const Point2& p) const
  {
    return this->strip ? this->normal.dot(p - this->apex) : (p - this->apex).norm();
  }
  /// Towards the foot.
  Point2 back(const Point2& p) const
  {
    return this->strip ? Point2(-this->normal) : Point2(this->apex - p);
  }

  /// In another triangle's plane.
  OffsetWindow moved(const FlatTriangle::Motion& motion) const;
  /// Its part between two places, seen from the foot.
  OffsetWindow between(const Point2& rightEnd, const Point2& leftEnd) const;
};

/// Fractions of a segment, in order.
struct SegmentPart
{
  double from = 0.0;
  double to = 1.0;
};
/// What is left of the part where a value that changes evenly from one end of the segment to the
/// other is not negative.
SegmentPart clipped(SegmentPart part, double atStart, double atEnd);
}
