// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PiecePlacement.h"

namespace flattening
{
/// Wires with a solution, and the piece placed by them.
struct PlacedWires
{
  WireSolution wires;
  PlacedPiece placed; ///< without positions where the wires have no solution to place
  /// Of the wires' angles, or IncompatibleKeys where keys were released for it.
  Status status;
};

/// Solves a piece's wires. Where the shapes of key curves contradict each other, the least set of
/// keys is released with which they do not (see releaseKeys()).
PlacedWires solveWithKeys(const PieceContext& context, const CurveRules& rules);

/// Places wires that are solved and not yet placed.
void place(const PieceContext& context, PlacedWires& result);

/// The same where the shapes of key curves can be met, but only by wires that fold triangles over:
/// without the least set of keys with which none folds when the piece is placed. No value where no
/// release helps, or nothing is locked that could be released.
std::optional<PlacedWires> placeWithoutFoldingKeys(
  const PieceContext& context, const PlacedPiece& folded, const WireSolution& wires);
}
