// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PiecePlacement.h"

#include "Angles/WireLayout.h"
#include "Base/Stopwatch.h"
#include "Embedding/Untangling.h"
#include "Quality/FlatteningQuality.h"
#include "Reference/InteriorRelaxation.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Where a start can be untangled at all it is by then: of 77 runs on real pieces and refinements
/// of them none was that had so many iterations without a fold less.
constexpr int patienceForStart = 40;
/// The isometric scheme moves all of it anyway.
constexpr double energyToleranceOfStart = 1e-3;

/// The isometric scheme with an energy that does not fold more than its start does.
IsometricSolution warpWithoutFolding(
  const PieceContext& context, const WireSolution& wires, PlacedPiece& placed)
{
  const Execution execution = context.execution.part(0.2, 1.0);
  const auto warp = [&](const IsometricOptions& options) {
    placed.energyUsed = options.energy.kind;
    IsometricSolution solution = warpIsometrically(
      context.piece, wires.problem, placed.positions, wires.angles.stretch, options, execution);
    placed.factorizations += solution.factorizations;
    return solution;
  };
  const Index flippedBefore = countFlipped(context.piece.mesh, placed.positions);
  const auto worse = [&](const IsometricSolution& candidate) {
    return !candidate.status.refused() &&
      (countFlipped(context.piece.mesh, candidate.positions) > flippedBefore ||
        !std::isfinite(candidate.distortionEnergy));
  };
  IsometricSolution solution = warp(context.options.isometric);
  if (worse(solution) && flippedBefore == 0)
  {
    // From a start without flips the energy with a barrier keeps it so.
    IsometricOptions withBarrier = context.options.isometric;
    withBarrier.energy.kind = DistortionEnergyKind::SymmetricDirichlet;
    solution = warp(withBarrier);
  }
  if (worse(solution))
  {
    // The start is the best that is known; its energy is finite without a barrier only.
    IsometricOptions still = context.options.isometric;
    still.maximumIterations = 0;
    still.energy.kind = DistortionEnergyKind::AsRigidAsPossible;
    solution = warp(still);
    if (!solution.status.refused()) // as where the run was cancelled there
    {
      solution.status = { StatusCode::NotConverged,
        "the isometric scheme found nothing better than where the wires' own angles put the piece",
        {}, { Remedy::MendSlivers } };
    }
  }
  return solution;
}

/// What the isometric scheme left flipped, with the wires where it has put them.
void untangleAfter(const PieceContext& context, PlacedPiece& placed)
{
  const Index flipped = countFlipped(context.piece.mesh, placed.positions);
  if (flipped == 0)
  {
    return;
  }
  Points2 positions = placed.positions;
  const UntanglingResult untangled =
    untangleInterior(context.piece, context.network, context.execution, positions);
  if (untangled.status.refused())
  {
    placed.status = untangled.status;
  }
  else if (countFlipped(context.piece.mesh, positions) < flipped)
  {
    placed.positions = std::move(positions);
  }
}
}

PlacedPiece placeWires(const PieceContext& context, const WireSolution& wires)
{
  Stopwatch watch;
  PlacedPiece placed;
  context.execution.report(0.1, "Placing the interior");
  placed.positions =
    layOutWires(context.network, wires.angles.theta, wires.angles.length).positions;
  InteriorOptions interior = context.options.interior;
  if (context.options.scheme == Scheme::Isometric)
  {
    interior.energyTolerance = std::max(interior.energyTolerance, energyToleranceOfStart);
  }
  noteStatus(placeInterior(context.piece, context.network, interior, context.execution,
               placed.positions, context.interiors)
               .status,
    placed.status);
  if (context.options.interior.method == InteriorMethod::AsRigidAsPossible &&
    !placed.status.refused())
  {
    // An energy with a barrier wants a start without a fold, whatever that takes.
    const bool onlyStart = context.options.scheme == Scheme::Isometric &&
      context.options.isometric.energy.kind == DistortionEnergyKind::AsRigidAsPossible;
    UntanglingOptions options;
    if (onlyStart)
    {
      options.patience = patienceForStart;
      options.nearby = true;
    }
    const UntanglingResult untangled = untangleInterior(
      context.piece, context.network, context.execution, placed.positions, options);
    noteStatus(untangled.status, placed.status);
  }
  placed.seconds = watch.seconds();
  return placed;
}

void warpPlacedPiece(const PieceContext& context, const WireSolution& wires, PlacedPiece& placed)
{
  placed.isometric = warpWithoutFolding(context, wires, placed);
  if (placed.isometric->status.ok() && placed.status.code == StatusCode::NotConverged)
  {
    placed.status = {}; // of an interior that was only the start
  }
  noteStatus(placed.isometric->status, placed.status);
  if (!placed.isometric->status.refused())
  {
    placed.positions = placed.isometric->positions;
  }
  if (!placed.status.refused())
  {
    untangleAfter(context, placed);
  }
}

PlacedPiece mapPiece(const PieceContext& context)
{
  LeastSquaresConformalOptions conformal = context.options.conformal;
  for (Index& pin : conformal.pins)
  {
    // The first copy of the pinned vertex in this piece.
    const Indices& vertices = context.piece.vertices;
    const auto copy = std::find_if(vertices.begin(), vertices.end(),
      [&](Index v) { return pin != none && context.cut.originalVertex[v] == pin; });
    pin = copy == vertices.end() ? none : static_cast<Index>(copy - vertices.begin());
  }
  if (conformal.pins[0] == none || conformal.pins[1] == none)
  {
    conformal.pins = { none, none };
  }
  LeastSquaresConformalMap map =
    leastSquaresConformalMap(context.piece.mesh, conformal, context.execution);
  PlacedPiece placed;
  placed.positions = std::move(map.positions);
  placed.status = std::move(map.status);
  return placed;
}
}
