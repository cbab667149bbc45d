// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outline.h"
#include "PatternStatus.h"

namespace flattening
{
namespace pattern
{
/// Where a notch lies: on the boundary edge from one point to the next, the cloth on the left.
struct NotchPlace
{
  std::array<Index, 2> edge{ none, none };
  double fraction = 0.0; ///< of the edge
  double arcLength =
    0.0; ///< on the surface, from the start of its wire, in the unit of the surface
  std::size_t wire = 0;
};

/// Places on both banks of every seam and dart at the same lengths on the surface: multiples of
/// the spacing from the start of the wire, up to a quarter of it before the end, or the middle
/// where there is none of these. A place and its partner lie on the same point of the curve before
/// the cut.
/// \param spacing in the unit of the surface; 0: none
PatternStatus placeNotches(const PatternSource& source, const PieceLoops& loops,
  const SewnPartners& partners, double spacing, std::vector<NotchPlace>& places);
}
}
