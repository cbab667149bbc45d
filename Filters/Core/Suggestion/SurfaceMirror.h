// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/IntrinsicMirror.h"
#include "Suggestion/SymmetryPlane.h"

namespace flattening
{
/// What maps a surface onto itself with its sides exchanged: a plane in space, or, where bending
/// has hidden it, an IntrinsicMirror.
class SurfaceMirror
{
public:
  explicit SurfaceMirror(const SymmetryPlane& plane)
    : error(plane.error)
    , Plane(plane)
  {
  }
  explicit SurfaceMirror(std::shared_ptr<const IntrinsicMirror> mirror)
    : error(mirror->error())
    , Intrinsic(std::move(mirror))
  {
  }

  /// Mirror images this near to the surface, in sqrt(area / pi), are taken as they are: coordinates
  /// of files have six digits.
  static constexpr double exact = 1e-5;

  /// Nothing where the mirror is an intrinsic one.
  const std::optional<SymmetryPlane>& plane() const { return this->Plane; }
  /// Null where it is a plane.
  const IntrinsicMirror* intrinsic() const { return this->Intrinsic.get(); }

  double side(const Point3& point) const
  {
    return this->Plane ? this->Plane->side(point) : this->Intrinsic->side(point);
  }
  Point3 mirrored(const Point3& point) const
  {
    return this->Plane ? this->Plane->mirrored(point) : this->Intrinsic->mirrored(point);
  }
  /// Into the plane, or onto the axis.
  Point3 projected(const Point3& point) const
  {
    return this->Plane ? this->Plane->projected(point) : this->Intrinsic->projected(point);
  }

  /// That of the plane or of the intrinsic mirror; of a piece the farthest that mirrored vertices
  /// and middles of edges lie from it, in sqrt(area / pi).
  double error;

private:
  std::optional<SymmetryPlane> Plane;
  std::shared_ptr<const IntrinsicMirror> Intrinsic;
};
}
