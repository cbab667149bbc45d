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

/// A measuring tape round the surface: the closed section with the plane through three points, or
/// the shortest one of those with the planes through two. It goes through them in their order, from
/// the first; `stations` gets where they are in its list. Errors: those of planeSection();
/// CurveLeavesSurface (no closed section goes through all points).
PlaneSection girth(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points,
  std::vector<std::size_t>* stations = nullptr);
}
