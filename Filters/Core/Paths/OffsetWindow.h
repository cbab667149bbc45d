// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"
#include "Surface/SurfacePoint.h"

namespace flattening
{
/// A triangle of a surface laid into the plane: its first corner at the origin, the second on the
/// first axis, the third above it.
class FlatTriangle
{
public:
  FlatTriangle(const TriangleMesh& mesh, Index triangle);

  const Point2& corner(Index k) const { return this->Corners[static_cast<std::size_t>(k % 3)]; }
  /// Where a point of the triangle lies.
  Point2 place(const TriangleMesh& mesh, const SurfacePoint& point) const;
  /// A vector of the triangle's plane in space.
  Point2 flat(const Point3& vector) const;
  Point3 spatial(const Point2& vector) const;
  /// The point of the triangle at a place; on a side or in a corner where it is that near to it, as
  /// a fraction of the height.
  SurfacePoint pointAt(const TriangleMesh& mesh, const Point2& place, double snap) const;
  /// A side of it is side `other.second` of another triangle: takes that one's places to this
  /// one's.
  struct Motion
  {
    Point2 turn = Point2::UnitX(); ///< cosine and sine
    Point2 shift = Point2::Zero();

    Point2 direction(const Point2& v) const
    {
      return { this->turn.x() * v.x() - this->turn.y() * v.y(),
        this->turn.y() * v.x() + this->turn.x() * v.y() };
    }
    Point2 place(const Point2& p) const { return this->direction(p) + this->shift; }
  };
  /// What takes places of this triangle to those of the one beyond side k, of which it is side j.
  Motion motionTo(Index k, const FlatTriangle& beyond, Index j) const;

private:
  Index Triangle;
  std::array<Point2, 3> Corners;
  Point3 Along;
  Point3 Across;
};

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
