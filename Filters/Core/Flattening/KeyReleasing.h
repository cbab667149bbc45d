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

/// Solves and places a piece's wires. Where the shapes of key curves contradict each other, or can
/// be met only by wires that fold triangles over, the least set of keys is released with which they
/// do not (see KeyReleaseSearch).
PlacedWires placeWithKeys(const PieceContext& context, CurveRules rules);
}
