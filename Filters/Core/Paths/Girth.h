// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PlaneSection.h"

namespace flattening
{
/// A measuring tape round the surface: the closed section with the plane through three points, or
/// the shortest one of those with the planes through two. It goes through them in their order, from
/// the first; `stations` gets where they are in its list. Errors: those of planeSection();
/// CurveLeavesSurface (no closed section goes through all points).
PlaneSection girth(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points,
  std::vector<std::size_t>* stations = nullptr);
}
