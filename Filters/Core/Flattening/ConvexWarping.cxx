// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/ConvexWarping.h"

#include "Embedding/ConvexEmbedding.h"
#include "Quality/BoundaryOverlap.h"
#include "Quality/FlatteningQuality.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// On the way to where the energy asked for starts from: more iterations than this help few.
constexpr int mostStartIterations = 60;
/// Mean of |J - R|^2 from which on pieces have minima of their own: those of garments and shoes
/// that lie well are below, and come to the same from both starts.
constexpr double farFromIsometric = 0.02;
constexpr double noticeable = 0.99;
/// Least over largest ratio of areas (E_h) that is no collapse yet.
constexpr double nearlyCollapsed = 0.25;
constexpr std::size_t fewListed = 1;
/// More iterations than these to the same minimum are too many.
constexpr int manyIterations = 30;
/// Beyond this mean of |J - R|^2 sheets without a barrier fold.
constexpr double surelyFolding = 0.35;
/// Of the convex start, in its radius.
constexpr double bending = 0.01;
/// What lengths and locked angles may miss where the iteration ended, in the model's units.
constexpr double kept = 1e-6;

constexpr auto barrier = DistortionEnergyKind::SymmetricDirichlet;

IsometricOptions optionsWithBarrier(const IsometricOptions& asked)
{
  IsometricOptions options = asked;
  if (asked.energy.kind != barrier)
  {
    options.maximumIterations = std::min(options.maximumIterations, mostStartIterations);
    options.energy.kind = barrier;
  }
  return options;
}

/// The same bent a little, by waves that no symmetry of the piece shares: a wire that is pressed
/// and straight would not know to which side to give way. Not where that folds.
Points2 bent(const TriangleMesh& mesh, const Points2& start)
{
  double radius = 0.0;
  for (const Point2& p : start)
  {
    radius = std::max(radius, p.norm());
  }
  Points2 result = start;
  for (Point2& p : result)
  {
    const Point2 q = p / radius;
    p += bending * radius *
      Point2(std::sin(2.3 * q.x() + 1.1 * q.y() + 0.4), std::cos(1.7 * q.x() - 0.9 * q.y() + 0.2));
  }
  return countFlipped(mesh, result) == 0 ? result : start;
}

bool keepsWires(const PlacedPiece& placed)
{
  return !placed.isometric->history.empty() && placed.isometric->history.back().constraint < kept;
}

MapDistortion quality(const PieceContext& context, const PlacedPiece& placed)
{
  return measureDistortion(context.piece.mesh, placed.positions, context.execution);
}

double distortion(const PieceContext& context, const PlacedPiece& placed)
{
  return quality(context, placed).rigidEnergy;
}

/// Whether triangles are pressed so much more than others that next to nothing is left of them.
bool collapses(const MapDistortion& summary)
{
  return summary.globalHomogeneity < nearlyCollapsed;
}

std::size_t overlaps(const PieceContext& context, const PlacedPiece& placed)
{
  return countBoundaryOverlaps(context.piece.mesh, placed.positions, fewListed).count;
}

PlacedPiece placedBy(IsometricSolution solution, DistortionEnergyKind kind)
{
  PlacedPiece placed;
  placed.factorizations = solution.factorizations;
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
  const Points2 start = embedConvexly(context.piece.mesh, context.execution);
  if (start.empty() || countFlipped(context.piece.mesh, start) > 0)
  {
    return std::nullopt;
  }
  AngleProblem unlocked = wires.problem;
  unlocked.locks = freeNodes(context.network);
  const Execution execution = context.execution.part(1.0, 1.0);
  const std::vector<double> rigid(wires.problem.groups.size(), 0.0);
  const IsometricOptions options = optionsWithBarrier(context.options.isometric);
  IsometricSolution solution = warpByPenaltyContinuation(
    context.piece, unlocked, bent(context.piece.mesh, start), rigid, options, execution);
  if (!solution.status.refused() && wires.locks())
  {
    const int before = solution.factorizations;
    solution = warpByPenaltyContinuation(
      context.piece, wires.problem, solution.positions, solution.stretch, options, execution);
    solution.factorizations += before;
  }
  if (solution.status.refused())
  {
    return std::nullopt;
  }
  PlacedPiece placed = placedBy(std::move(solution), barrier);
  const DistortionEnergyKind asked = context.options.isometric.energy.kind;
  if (asked != barrier && distortion(context, placed) < surelyFolding)
  {
    IsometricSolution last = warpByPenaltyContinuation(context.piece, wires.problem,
      placed.positions, placed.isometric->stretch, context.options.isometric, execution);
    if (last.status.refused())
    {
      return std::nullopt;
    }
    const bool folds = countFlipped(context.piece.mesh, last.positions) > 0;
    PlacedPiece other = placedBy(std::move(last), asked);
    placed.factorizations += other.factorizations;
    other.factorizations = placed.factorizations;
    const MapDistortion result = quality(context, other);
    const bool pressed =
      collapses(result) && result.globalHomogeneity < quality(context, placed).globalHomogeneity;
    if (!folds && !pressed && (keepsWires(other) || !keepsWires(placed)))
    {
      placed = std::move(other);
    }
  }
  return placed;
}

bool isDoubtful(const PieceContext& context, const PlacedPiece& placed)
{
  const bool otherEnergy = placed.energyUsed != context.options.isometric.energy.kind;
  if (otherEnergy || placed.isometric->status.code == StatusCode::NotConverged ||
    countFlipped(context.piece.mesh, placed.positions) > 0)
  {
    return true;
  }
  const MapDistortion summary = quality(context, placed);
  return summary.rigidEnergy > farFromIsometric || collapses(summary);
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
  const std::size_t crossings = overlaps(context, second);
  const std::size_t crossingsBefore = overlaps(context, first);
  if ((crossings == 0) != (crossingsBefore == 0))
  {
    return crossings == 0;
  }
  const MapDistortion one = quality(context, first);
  const MapDistortion other = quality(context, second);
  if (collapses(one) || collapses(other))
  {
    return other.globalHomogeneity > one.globalHomogeneity;
  }
  if (other.rigidEnergy > noticeable * one.rigidEnergy &&
    one.rigidEnergy > noticeable * other.rigidEnergy)
  {
    const bool late = first.isometric->iterations > manyIterations &&
      second.isometric->iterations < first.isometric->iterations;
    return second.status.ok() && (!first.status.ok() || late);
  }
  return other.rigidEnergy < one.rigidEnergy;
}
}
