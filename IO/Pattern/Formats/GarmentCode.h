// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/DrawingSource.h"
#include "Outlines/Pattern.h"

namespace flattening::pattern
{
/// A flattening as the JSON of GarmentCode (M. Korosteleva, O. Sorkine-Hornung, GarmentCode:
/// programming parametric sewing patterns, ACM Transactions on Graphics 42(6), 2023): panels
/// without allowance, in centimetres, with straight and cubic edges; stitches between edges of the
/// same length; each panel placed in space where its piece fits the surface best. Numbers are
/// written such that reading them gives the same bits. Pieces that were panels are
/// written as these again.
/// \param source as it was read, for its panels
/// \param all what prepareDrawing() made of it
/// \param drawing for the names of the pieces
/// \return InvalidPattern for a piece with a hole, which the format cannot hold
Status makeGarmentCode(
  const PatternSource& source, const DrawingSource& all, const Pattern& drawing, std::string& json);
}
