// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Triangles on the vertices of a surface, known by the lengths of their edges alone. They need not
/// be triangles of the mesh; two may share two edges, and one may have a corner twice.
struct IntrinsicTriangulation
{
  Triangles triangles;
  /// Cotangent of the angle at each corner.
  std::vector<std::array<double, 3>> cotangents;
};

/// The intrinsic Delaunay triangulation of a surface: inner edges are flipped, each within the two
/// triangles next to it unfolded, until no two angles opposite to an edge add up to more than pi
/// (A. I. Bobenko, B. A. Springborn, "A discrete Laplace-Beltrami operator for simplicial
/// surfaces", Discrete & Computational Geometry 38(4), 2007). Then no edge's cotangents add up to
/// less than zero, so that the Laplacian of a surface with obtuse triangles has a maximum principle
/// again. The surface itself does not change, nor its angle defects, nor its boundary.
IntrinsicTriangulation intrinsicDelaunay(const TriangleMesh& mesh);
}
