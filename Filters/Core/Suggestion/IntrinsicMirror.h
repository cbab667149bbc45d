// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Surface/SurfaceLocator.h"

#include <memory>

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
}
