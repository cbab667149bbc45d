// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/SurfaceTrace.h"

namespace flattening
{
/// A curve in which a plane meets a surface: closed, its last point being the first, or from
/// boundary to boundary.
struct PlaneSection
{
  SurfacePath path;
  double length = 0.0;
  bool closed = false;
  Status status;
};

/// The curve of the section with the plane through a point of the surface that goes through this
/// point. Errors: EmptySurface; InvalidPointId; InvalidOption (no normal); CurveLeavesSurface (the
/// plane touches the surface at the point and does not cross it).
PlaneSection planeSection(
  const TriangleMesh& mesh, const SurfacePoint& point, const Point3& normal);

/// All curves of a section. \pre the normal is not zero.
std::vector<PlaneSection> planeSections(
  const TriangleMesh& mesh, const Point3& point, const Point3& normal);
}
