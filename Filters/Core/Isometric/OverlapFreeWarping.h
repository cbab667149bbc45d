// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Isometric/IsometricWarping.h"

namespace flattening
{
/// A free boundary that does not cross itself: warpIsometrically() from positions that have no fold
/// and no overlap, so that no step makes one.
///
/// Where parts of the boundary are near to each other, and in holes, the plane between them is
/// filled with triangles, which count for next to nothing but must not turn over; after a few steps
/// it is filled anew, at rest where the boundary is then (Z. Jiang, S. Schaefer, D. Panozzo,
/// "Simplicial Complex Augmentation Framework for Bijective Maps", ACM Transactions on Graphics
/// 36(6), 2017). So parts that press on each other end up beside each other. A step that overlaps
/// where nothing is filled is taken in part, and wider openings are filled for the next one. Ends
/// where rounds lower the energy by less than a thousandth.
/// \param enough strain on 95 % of the area, at which it ends as well, or where that comes no nearer;
/// 0 for none
/// \param options with an energy that has a barrier
/// \return NotConverged where the lengths of wires cannot be kept so, or every further step would
/// overlap; the positions have no overlap
IsometricSolution warpWithoutOverlap(const Piece& piece, const AngleProblem& problem,
  const Points2& start, double enough, const IsometricOptions& options, const Execution& execution);
}
