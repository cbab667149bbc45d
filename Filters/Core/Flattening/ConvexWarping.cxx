// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/ConvexWarping.h"

#include "Embedding/ConvexEmbedding.h"
#include "Quality/FlatteningQuality.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// A way round for one piece in many: more iterations than this help few.
constexpr int mostIterations = 60;
/// Mean of |J - R|^2 from which on pieces have minima of their own: those of garments and shoes
/// that lie well are below, and come to the same from both starts.
constexpr double farFromIsometric = 0.02;
constexpr double noticeable = 0.99;
/// What lengths and locked angles may miss where the iteration ended, in the model's units.
constexpr double kept = 1e-6;

IsometricSolution warp(const PieceContext& context, const AngleProblem& problem,
  const Points2& start, const std::vector<double>& stretch, DistortionEnergyKind kind)
{
  IsometricOptions options = context.options.isometric;
  options.maximumIterations = std::min(options.maximumIterations, mostIterations);
  options.energy.kind = kind;
  return warpIsometrically(
    context.piece, problem, start, stretch, options, context.execution.part(1.0, 1.0));
}

bool keepsWires(const PlacedPiece& placed)
{
  return !placed.isometric->history.empty() && placed.isometric->history.back().constraint < kept;
}

double distortion(const PieceContext& context, const PlacedPiece& placed)
{
  return measureFlattening(context.piece.mesh, placed.positions, {}, context.execution)
    .summary.rigidEnergy;
}

PlacedPiece placedBy(IsometricSolution solution, DistortionEnergyKind kind)
{
  PlacedPiece placed;
  placed.energyUsed = kind;
  placed.fromConvexStart = true;
  placed.status = solution.status;
  placed.positions = solution.positions;
  placed.isometric = std::move(solution);
  return placed;
}
}

std::optional<PlacedPiece> warpFromConvexStart(
  const PieceContext& context, const WireSolution& wires)
{
  constexpr auto barrier = DistortionEnergyKind::SymmetricDirichlet;
  const Points2 start = embedConvexly(context.piece.mesh, context.execution);
  if (start.empty() || countFlipped(context.piece.mesh, start) > 0)
  {
    return std::nullopt;
  }
  AngleProblem unlocked = wires.problem;
  unlocked.locks = freeNodes(context.network);
  const std::vector<double> rigid(wires.problem.groups.size(), 0.0);
  IsometricSolution solution = warp(context, unlocked, start, rigid, barrier);
  if (!solution.status.refused() && wires.locks())
  {
    solution = warp(context, wires.problem, solution.positions, solution.stretch, barrier);
  }
  if (solution.status.refused())
  {
    return std::nullopt;
  }
  PlacedPiece placed = placedBy(std::move(solution), barrier);
  const DistortionEnergyKind asked = context.options.isometric.energy.kind;
  if (asked != barrier)
  {
    IsometricSolution last =
      warp(context, wires.problem, placed.positions, placed.isometric->stretch, asked);
    if (last.status.refused())
    {
      return std::nullopt;
    }
    const bool folds = countFlipped(context.piece.mesh, last.positions) > 0;
    PlacedPiece other = placedBy(std::move(last), asked);
    if (!folds && (keepsWires(other) || !keepsWires(placed)))
    {
      placed = std::move(other);
    }
  }
  return placed;
}

bool isDoubtful(const PieceContext& context, const PlacedPiece& placed)
{
  const bool folded = countFlipped(context.piece.mesh, placed.positions) > 0;
  const bool otherEnergy = placed.energyUsed != context.options.isometric.energy.kind;
  return folded || otherEnergy || placed.isometric->status.code == StatusCode::NotConverged ||
    distortion(context, placed) > farFromIsometric;
}

bool isBetter(const PieceContext& context, const PlacedPiece& second, const PlacedPiece& first)
{
  const Index folds = countFlipped(context.piece.mesh, second.positions);
  const Index foldsBefore = countFlipped(context.piece.mesh, first.positions);
  if (folds != foldsBefore)
  {
    return folds < foldsBefore;
  }
  if (keepsWires(second) != keepsWires(first))
  {
    return keepsWires(second);
  }
  const double one = distortion(context, first);
  const double other = distortion(context, second);
  const bool alike = other > noticeable * one && one > noticeable * other;
  return alike ? second.status.ok() && !first.status.ok() : other < one;
}
}
