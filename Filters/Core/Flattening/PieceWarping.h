// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PieceSolution.h"

namespace flattening
{
/// The isometric scheme from where placeWires() has put the piece; what it folds is untangled.
/// Where the result is doubtful, from a convex start as well, and the better one counts.
void warpPiece(const PieceContext& context, PieceSolution& piece);

/// The isometric scheme from a start that does not fold, whatever the piece (embedConvexly(); with
/// a free boundary a conformal map where that does not fold either, and no wire at first), on a way
/// that does not: first by an energy that no triangle can be turned over against, without the
/// shapes of key curves, then with them, and last by the energy of the options where that neither
/// folds nor nearly collapses triangles. What overlaps then is kept from it on request, on trial
/// from the start (see FlatteningOptions::enoughStrain). Without a value where there is no such
/// start, or the run was cancelled.
std::optional<PieceSolution> warpFromConvexStart(
  const PieceContext& context, const PieceSolution& wires, const IsometricOptions& asked);

/// The isometric scheme from where FlatteningOptions::start has the piece. No value where there is
/// no such start, where anything but lengths holds the wires (key or elastic curves, connectors, a
/// cloth), where overlaps are to be prevented, and where start or solution fold a triangle or it
/// comes to no minimum.
std::optional<PieceSolution> warpFromGivenStart(
  const PieceContext& context, const CurveRules& rules);
}
