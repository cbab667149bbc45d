// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Of a piece more overlaps than these are counted, but not listed.
constexpr std::size_t mostListedOverlaps = 1000;
/// Pairs of runs of boundary edges that are looked at before counting ends: some seconds. The edges
/// of a piece are short beside it, so that far fewer are near each other; in a scribble of n long
/// edges all n^2 / 2 may be.
constexpr std::size_t maxOverlapVisits = 200000000;

struct BoundaryOverlaps
{
  std::size_t count = 0;
  /// False where there was too much to look at: there are `count` overlaps or more.
  bool complete = true;
  std::vector<std::array<Index, 2>> listed; ///< in ascending order
};

/// Pairs of boundary half-edges at which a flattened surface covers a part of the plane twice, each
/// pair once: all are counted, at most `most` listed. One piece without flipped triangles is free
/// of overlap exactly where there is none.
///
/// Sides that merely touch are no overlap: a cut in a developable surface lies flat with both sides
/// on top of each other, equal up to rounding. So each boundary vertex is first moved inwards,
/// along the bisector of its angle, by `contact` times the size of its boundary loop (by less in
/// slivers, so that it stays within its own triangles); whatever still meets overlaps deeper than
/// that. From there on the test is exact: signs of orientation are those of exact arithmetic, and
/// edges that touch, cross or lie on each other all count unless they share a vertex.
BoundaryOverlaps countBoundaryOverlaps(const TriangleMesh& mesh, const Points2& positions,
  std::size_t most, double contact = 1e-9, std::size_t maxVisits = maxOverlapVisits);

/// The same without a count: ends as soon as `most` are found.
std::vector<std::array<Index, 2>> findBoundaryOverlaps(
  const TriangleMesh& mesh, const Points2& positions, std::size_t most, double contact = 1e-9);
}
