// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace flattening
{
// Triangles that go on with each other at an edge are partners: each half-edge names that of the
// other triangle, or none. Crowded edges have more than two triangles.

/// The points of an edge, the lower one first.
std::pair<Index, Index> endsOf(const Triangles& triangles, Index h);

/// Parts partners that cannot be oriented alike, at crowded edges and at others where one of them
/// is turned over. \return the half-edges parted at others, one of each edge
Indices partOneSided(
  const Triangles& triangles, const std::vector<Indices>& crowded, Indices& partner);

/// Triangles that are not partners at an edge, but have both its ends in common, are parted at one
/// more edge. \param pairs whether there are such at edges of two triangles. \return the ends of
/// the edges
Indices partAtEnds(const Triangles& triangles, std::size_t points, bool pairs, Indices& partner);

/// Gives each fan of triangles at a point a point of its own; that of the most triangles keeps the
/// old one. \return the points that had several
Indices splitFans(Triangles& triangles, Points3& points, Indices& source, const Indices& partner);
}
