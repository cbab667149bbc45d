// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TriangleList.h"

namespace wirewarp
{
/// A closed way along the boundary of a surface.
struct BoundaryLoop
{
  std::vector<vtkIdType> points;
  vtkIdType polygon = 0;  ///< of one of the triangles at it
  double across = 0.0;    ///< diagonal of its bounding box
  bool outermost = false; ///< the longest of its connected part of the surface
};

/// All of them, with the surface on the left. In time linear in the triangles.
std::vector<BoundaryLoop> boundaryLoops(const TriangleList& list);

/// How many edges of the loops lie on another one, between points of their own, and one of these
/// points.
struct UnjoinedEdges
{
  std::size_t count = 0;
  vtkIdType point = 0;
};
UnjoinedEdges unjoinedEdges(const TriangleList& list, const std::vector<BoundaryLoop>& loops);
}
