// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/FeatureCurve.h"
#include "Surface/TriangleMesh.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace flattening
{
/// Where the area of a surface lies.
struct SurfaceMoments
{
  double area = 0.0;
  Point3 center = Point3::Zero();
  /// Of unit length, in columns: from the one along which the surface extends least.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

SurfaceMoments momentsOf(const TriangleMesh& mesh);

/// A plane that mirrors a surface onto itself.
struct SymmetryPlane
{
  Point3 normal = Point3::UnitX(); ///< of unit length
  double offset = 0.0;             ///< points p of the plane: normal . p = offset
  /// Mean distance of mirrored vertices from the surface, as a fraction of sqrt(area / pi).
  double error = 0.0;
  double spread = 0.0; ///< the distance within which 95 % of them are

  double side(const Point3& point) const { return this->normal.dot(point) - this->offset; }
  Point3 mirrored(const Point3& point) const
  {
    return point - 2.0 * this->side(point) * this->normal;
  }
  Points3 mirrored(Points3 line) const
  {
    for (Point3& point : line)
    {
      point = this->mirrored(point);
    }
    return line;
  }
  Point3 projected(const Point3& point) const { return point - this->side(point) * this->normal; }
};

/// Of sqrt(area / pi), how far 95 % of a mirrored surface may be from itself.
inline constexpr double mirrorTolerance = 0.03;

/// The plane through the centre of area across the axis along which the surface extends least.
SymmetryPlane flattestPlane(const TriangleMesh& mesh);

/// Finds the plane through the centre of area across one of the principal axes, or across x, y or
/// z, that mirrors the surface onto itself best, brings mirrored vertices and surface as near to
/// each other as it can (closest points, point to plane: Y. Chen, G. Medioni, "Object modelling by
/// registration of multiple range images", Image and Vision Computing 10(3), 1992), and takes it
/// where 95 % of them are within `tolerance` times sqrt(area / pi), and the mean distance of the
/// surface from the plane is not.
std::optional<SymmetryPlane> findSymmetryPlane(
  const TriangleMesh& mesh, double tolerance = mirrorTolerance);

/// The level direction in which a body faces, up being upAxisOf() its box: along its plane of
/// symmetry where that stands upright and about so, otherwise along the shorter level side.
Point3 frontOf(const TriangleMesh& mesh);

/// What a user says of the mirror plane.
struct SymmetryChoice
{
  enum Kind
  {
    Off,
    Found,  ///< where there is one
    Forced, ///< the best that there is
    Stated
  };
  Kind kind = Found;
  SymmetryPlane plane; ///< the one stated, without its error
};

/// "on", "off", "force", the name of a curve, or a plane as "x", "y=0.5" or "NX,NY,NZ,OFFSET".
///
/// The plane of a curve is that in which its points lie best, and of a straight one that through
/// the mean normal of the surface there.
/// Errors: InvalidOption (another text; a normal of no length).
Status readSymmetry(const std::string& text, const TriangleMesh& mesh,
  const std::vector<Polyline>& curves, SymmetryChoice& choice);

/// The plane with its error, where images may be of another surface.
SymmetryPlane measuredPlane(const TriangleMesh& mesh, const SymmetryPlane& plane);
SymmetryPlane measuredPlane(
  const TriangleMesh& mesh, const TriangleMesh& other, const SymmetryPlane& plane);
}
