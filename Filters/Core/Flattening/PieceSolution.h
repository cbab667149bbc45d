// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Embedding/InteriorSystem.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"

namespace flattening
{
/// What every step of flattening a piece reads. It only refers to what it names.
struct PieceContext
{
  const Piece& piece;
  const WireNetwork& network;
  const CutSurface& cut;
  const std::vector<FeatureCurve>& curves;
  const FlatteningOptions& options;
  const Execution& execution;
  /// Factors of the interior that outlive the run; null where none do.
  InteriorSystems* interiors = nullptr;
  /// Whether a plane has room for the piece; null: not computed.
  const AreaForecast* area = nullptr;

  bool exceedsPlanarArea() const
  {
    return this->area && (this->area->deep() || this->area->tube());
  }
};

/// A piece on its way into the plane and there: each step fills in its part.
struct PieceSolution
{
  CurveRules rules; ///< with which the wires' problem was posed
  AngleProblem problem;
  AngleSolution angles; ///< of the wires
  Points2 positions;    ///< per piece vertex; empty until it is placed
  /// Isometric scheme: what it did, whether from a convex embedding or from
  /// FlatteningOptions::start instead of the wires' angles, and the factorizations of all that was
  /// tried.
  std::optional<IsometricSolution> isometric;
  bool fromConvexStart = false;
  bool fromGivenStart = false;
  int factorizations = 0;
  /// Where options have a cloth: how it lies there, and whether it has the cloth's least energy.
  std::optional<GrainReport> grain;
  bool clothSolved = false;
  Indices freeDarts; ///< whose legs stay free although others were asked for, ascending
  /// On 95 % of the area, where legs of darts that fold on each other cost much; 0 where not.
  double strainOfFreeLegs = 0.0;
  double strainOfLegs = 0.0;
  /// Of the piece with sides of cuts joined, where they are; its edges end at vertices of the
  /// piece.
  std::optional<WireNetwork> joinedNetwork;
  Status placement; ///< of what follows the wires' angles
  /// Of the wires' angles, or IncompatibleKeys where keys were released for it; once the scheme is
  /// through, of all.
  Status status;
  /// Each step notes what it did; completed by reportPiece().
  PieceReport report;
  double secondsWires = 0.0;
  double secondsInterior = 0.0;

  /// Whether key curves hold an angle: there is something to release.
  bool locks() const { return this->problem.locks.lockedCount > 0; }
};

/// The first defect counts, unless a later step has no result at all.
inline void noteStatus(Status status, Status& first)
{
  if (!status.ok() && (first.ok() || status.refused()))
  {
    first = std::move(status);
  }
}
}
