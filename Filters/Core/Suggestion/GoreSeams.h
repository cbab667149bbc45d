// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutSetSearch.h"

namespace flattening
{
/// Pieces into which half planes through an axis part a round surface, as those of balloons, balls,
/// domes, lampshades and caps, or a ring, whose pieces are cut open along its inside.
struct Gores
{
  CutSet set;
  SymmetryPlane plane; ///< which mirrors the seams
  bool equal = false;  ///< of a surface of revolution
};

/// The fewest gores that meet the bound, or as many as pieces are wanted, of a surface that each
/// half plane cuts in one line from end to end, or in one loop. No cuts where there are none.
///
/// The axis goes through the center of area along a principal axis, x, y or z: the one of a surface
/// of revolution, where planes through it at several angles mirror the surface onto itself (see
/// findSymmetryPlane()), otherwise that in the mirror plane which takes the least seam, or strains
/// a number of pieces least. Gores of a surface of revolution have equal angles, others equal
/// widths in the middle.
/// \param plane a mirror plane, in which the first seam lies \param trials of the surface
Gores findGores(const TriangleMesh& mesh, const SymmetryPlane& plane, const CutTrials& trials,
  const SearchOptions& wanted, TrialBudget& budget, const Execution& execution);
}
