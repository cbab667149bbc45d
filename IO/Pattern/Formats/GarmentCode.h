// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/Pattern.h"
#include "Outlines/PatternSource.h"

namespace flattening::pattern
{
class FairCache;

/// A flattening as the JSON of GarmentCode (M. Korosteleva, O. Sorkine-Hornung, GarmentCode:
/// programming parametric sewing patterns, ACM Transactions on Graphics 42(6), 2023): panels
/// without allowance, in centimetres, with straight and cubic edges; stitches between edges of the
/// same length; each panel placed in space where its piece fits the surface best. Numbers are
/// written such that reading them gives the same bits. Pieces that were panels (SourcePanels) are
/// written as these again.
/// \param drawing for the names of the pieces
/// \param cache of smooth borders; null: none
/// \return InvalidPattern for a piece with a hole, which the format cannot hold
Status makeGarmentCode(const PatternSource& source, const PatternOptions& options,
  const Pattern& drawing, std::string& json, FairCache* cache = nullptr);
}
