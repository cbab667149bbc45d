// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Of a piece more overlaps than these are not asked for.
constexpr std::size_t mostOverlaps = 1000;

/// Pairs of boundary half-edges at which a flattened surface covers a part of the plane twice, each
/// pair once and in ascending order; at most `most` of them. One piece without flipped triangles is
/// free of overlap exactly where there is none.
///
/// Banks that merely touch are no overlap: a cut in a developable surface lies flat with both banks
/// on top of each other, equal up to rounding. So each boundary vertex is first moved inwards,
/// along the bisector of its angle, by `contact` times the size of its boundary loop (by less in
/// slivers, so that it stays within its own triangles); whatever still meets overlaps deeper than
/// that. From there on the test is exact: signs of orientation are those of exact arithmetic, and
/// edges that touch, cross or lie on each other all count unless they share a vertex.
std::vector<std::array<Index, 2>> findBoundaryOverlaps(
  const TriangleMesh& mesh, const Points2& positions, std::size_t most, double contact = 1e-9);
}
