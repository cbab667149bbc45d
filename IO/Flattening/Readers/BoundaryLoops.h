// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TriangleList.h"

#include <cstdint>
#include <vector>

namespace wirewarp
{
/// A closed way along the boundary of a surface.
struct BoundaryLoop
{
  std::vector<std::int64_t> points;
  std::int64_t polygon = 0; ///< of one of the triangles at it
  double across = 0.0;      ///< diagonal of its bounding box
  double length = 0.0;
  bool outermost = false; ///< the longest of its connected part of the surface
};

/// All of them, with the surface on the left. In time linear in the triangles.
std::vector<BoundaryLoop> boundaryLoops(const TriangleList& list);

/// The same, the longest first: opening 1, opening 2, ...
std::vector<BoundaryLoop> openings(const TriangleList& list);

/// Points at sides of triangles that no other triangle shares, whichever way triangles turn.
std::vector<std::int64_t> boundaryPoints(const TriangleList& list);
}
