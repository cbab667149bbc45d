// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningResult.h"
#include "Flattening/PieceContext.h"
#include "Flattening/PieceWires.h"

namespace flattening
{
/// A piece in the plane, and how it came there.
struct PlacedPiece
{
  Points2 positions; ///< per piece vertex
  /// Isometric scheme: what was done.
  std::optional<IsometricSolution> isometric;
  /// Isometric scheme: the energy of the solution; another one than was asked for where that folds.
  DistortionEnergyKind energyUsed = DistortionEnergyKind::AsRigidAsPossible;
  /// Isometric scheme: the solution came from a convex embedding, not from the wires' angles.
  bool fromConvexStart = false;
  /// Isometric scheme: the solution came from FlatteningOptions::start.
  bool fromGivenStart = false;
  /// Where options have a cloth: how it lies there.
  std::optional<GrainReport> grain;
  bool clothSolved = false; ///< by the isometric scheme with the cloth's energy
  /// Isometric scheme: of all that was tried, whichever counts.
  int factorizations = 0;
  Status status;
  double seconds = 0.0; ///< that placeWires() took
};

/// The first thing that went wrong is what is said, unless a later stage has no result at all.
inline void noteStatus(Status status, Status& first)
{
  if (!status.ok() && (first.ok() || status.refused()))
  {
    first = std::move(status);
  }
}

/// Positions from the wires' angles: the layout of the wires, the interior between them, untangled
/// where that is as rigid as possible. Status: that of the first stage that failed.
PlacedPiece placeWires(const PieceContext& context, const WireSolution& wires);

/// The isometric scheme from where placeWires() has put the piece; what it folds is untangled.
void warpPlacedPiece(const PieceContext& context, const WireSolution& wires, PlacedPiece& placed);

/// The least squares conformal map of the piece.
PlacedPiece mapPiece(const PieceContext& context);
}
