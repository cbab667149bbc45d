// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Suggestion/SymmetryPlane.h"
#include "Surface/SurfaceLocator.h"

#include <array>
#include <memory>
#include <optional>

namespace flattening
{
/// Maps a disk onto itself as a mirror would that was flat before the disk was bent: distances on
/// the surface stay, those in space need not. No plane is needed, as no bending without stretching
/// changes angles and lengths.
///
/// A harmonic map (embedConvexly()) of the disk to one whose boundary is a circle, by lengths, is
/// given by lengths and angles on the surface alone, so that it takes the surface's mirror to that
/// of the circle across a diameter.
class IntrinsicMirror
{
public:
  /// Looks for the diameter: the boundary, its turning along its length, has to be its own image
  /// the other way round. The best that maps the surface onto itself with a mean strain below
  /// `tolerance` is taken. \return null where there is none, the surface is no disk, or the run was
  /// cancelled
  static std::shared_ptr<const IntrinsicMirror> find(
    const TriangleMesh& mesh, const Execution& execution, double tolerance = 0.03);

  IntrinsicMirror(const IntrinsicMirror&) = delete;
  IntrinsicMirror& operator=(const IntrinsicMirror&) = delete;

  /// Image of a point on or near the surface.
  Point3 mirrored(const Point3& point) const;
  /// A point of the axis near a point of the surface.
  Point3 projected(const Point3& point) const;
  /// About how far from the axis, with a sign for its side.
  double side(const Point3& point) const;
  /// Mean over the area of the larger |ln| of the two stretches by which the surface is mapped.
  double error() const { return this->Error; }
  /// Where the axis meets the boundary.
  const std::array<Point3, 2>& axis() const { return this->Axis; }

private:
  IntrinsicMirror(const TriangleMesh& mesh, const Points2& flat, double turn);

  Point2 onCircle(const Point3& point) const;
  Point3 onSurface(const Point2& point) const;
  double strainOf(Index triangle) const;
  double meanStrain(Index step) const;

  TriangleMesh Mesh;
  TriangleMesh Flat;
  SurfaceLocator Locator;
  SurfaceLocator FlatLocator;
  Point2 Along; ///< the axis, which goes through the circle's centre
  Point2 Across;
  double Error = 0.0;
  std::array<Point3, 2> Axis;
};

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
  Points3 mirrored(Points3 line) const
  {
    for (Point3& point : line)
    {
      point = this->mirrored(point);
    }
    return line;
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
