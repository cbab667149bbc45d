// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

namespace flattening
{
/// A half-edge (3 t + k runs in triangle t from corner k) under its two vertices.
struct HalfedgeKey
{
  Index low = none;
  Index high = none;
  Index halfedge = none;
};

/// All half-edges of triangles, those of one edge next to each other in ascending order; by a
/// counting sort over the lower vertex, which takes linear time.
std::vector<HalfedgeKey> sortedSides(const Triangles& triangles, std::size_t vertexCount);

/// Per half-edge the other one of its edge; none where it is alone. \param sides as sorted.
Indices pairSides(const std::vector<HalfedgeKey>& sides);

/// The half-edges of each edge of more than two triangles. \param sides as sorted.
std::vector<Indices> crowdedEdges(const std::vector<HalfedgeKey>& sides);

/// As pairSides() in less time where the surface is in order: at most two triangles at an edge,
/// which run along it in opposite directions and have different third corners. Empty where it is
/// not, or where too many edges meet in a vertex to be quick.
Indices pairOrientedSides(const Triangles& triangles, std::size_t vertexCount);
}
