// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfacePoint.h"

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
}
