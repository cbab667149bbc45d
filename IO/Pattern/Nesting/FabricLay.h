// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/Pattern.h"

namespace flattening::pattern
{
/// Cloth to cut from.
struct FabricOptions
{
  double width = 0.0; ///< across the grain, millimetres; 0: pieces are not laid on cloth
  bool nap = false;   ///< it has an up and a down, which all pieces must share
  double gap = 5.0;   ///< least distance of pieces, millimetres
};

/// Lays all copies of all pieces on cloth of a width, as short as a search of bounded work finds
/// it: the pieces of the pattern become these copies, with their grain along the cloth, half of a
/// pair turned over. Each copy goes to the highest free place (the complement of no-fit polygons,
/// R. C. Art, IBM Cambridge Scientific Center report 36.Y08, 1966), in orders that begin with large
/// pieces and are improved by swapping two. Without nap pieces may be turned by half a turn.
/// Needs Clipper.
/// \return PatternTooLarge where a piece is wider than the cloth; InvalidOption for too many copies
Status layOnFabric(const FabricOptions& options, Pattern& pattern);
}
