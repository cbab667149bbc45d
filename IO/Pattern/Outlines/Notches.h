// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/Joins.h"

namespace flattening::pattern
{
/// Where a notch lies: on the boundary edge from one point to the next, the cloth on the left.
struct NotchPlace
{
  std::array<Index, 2> edge{ none, none };
  double fraction = 0.0; ///< of the edge
  double arcLength =
    0.0; ///< on the surface, from the start of its wire, in the unit of the surface
  std::size_t wire = 0;
  bool isDrawn = true; ///< false: two marks beside it are drawn in its place
  bool isStop = true;  ///< false: such a mark, where no interval of the curve ends
};

/// Distance of the two marks of a double notch along the border, millimetres: a quarter of an inch,
/// as on printed patterns.
constexpr double doubleNotchDistance = 6.35;

/// Places on both banks of every seam and dart, and on the edges of the boundary that have notches
/// of their own. A place and its partner lie on the same point of the curve before the cut. A
/// double notch is a place that is not drawn and two marks beside it.
/// \param stations of each wire, lengths on the surface from its start: the distances that the
/// options have for its name, up to its length, or along each of its joins multiples of the
/// spacing, which tell the ends of seams apart
/// \return InvalidOption where a notch is farther out than any wire of its name is long, or notches
/// are too close
Status placeNotches(const PatternSource& source, const BorderEdges& border,
  const SewnPartners& partners, const std::vector<Join>& joins, const PatternOptions& options,
  std::vector<std::vector<double>>& stations, std::vector<NotchPlace>& places);
}
