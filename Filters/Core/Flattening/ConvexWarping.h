// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PiecePlacement.h"

namespace flattening
{
/// The isometric scheme from a start that does not fold, whatever the piece (embedConvexly()), on a
/// way that does not: first by an energy that no triangle can be turned over against, without the
/// shapes of key curves, then with them, and last by the energy of the options where that neither
/// folds nor nearly collapses triangles. Without a value where there is no such start, or the run
/// was cancelled.
std::optional<PlacedPiece> warpFromConvexStart(
  const PieceContext& context, const WireSolution& wires);

/// Whether the isometric scheme's result may have been led astray by its start: it is folded, has
/// triangles that nearly collapse, is not at a minimum, or far from isometric.
bool isDoubtful(const PieceContext& context, const PlacedPiece& placed);

/// Whether to prefer the second to the first: fewer folds, then wires as asked for, no overlap, no
/// triangle that nearly collapses, then less distortion, by more than a percent, then a minimum,
/// and one that is not found after very many steps.
bool isBetter(const PieceContext& context, const PlacedPiece& second, const PlacedPiece& first);
}
