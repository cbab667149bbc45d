// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceWarping.h"

#include "Embedding/ConvexEmbedding.h"
#include "Embedding/LeastSquaresConformalMap.h"
#include "Embedding/Untangling.h"
#include "Isometric/OverlapFreeWarping.h"
#include "Quality/BoundaryOverlap.h"
#include "Quality/FlatteningQuality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// On the way to where the energy asked for starts from: more iterations than this help few.
constexpr int maxStartIterations = 60;
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
constexpr double wiresKeptWithin = 1e-6;

/// Mean of |J|^2 + |J^-1|^2, at least 4, from which few iterations are left.
constexpr double goodStart = 8.0;

constexpr auto barrier = DistortionEnergyKind::SymmetricDirichlet;

IsometricOptions optionsWithBarrier(const IsometricOptions& asked)
{
  IsometricOptions options = asked;
  if (asked.energy.kind != barrier)
  {
    options.maximumIterations = std::min(options.maximumIterations, maxStartIterations);
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

/// A map without a fold, in the size in which it has least of the energy with a barrier: the
/// conformal one where it is good, else the better of that and the convex one. Empty: both fold.
Points2 unfoldedMap(const PieceContext& context)
{
  const TriangleMesh& mesh = context.piece.mesh;
  Points2 best;
  double least = std::numeric_limits<double>::infinity();
  for (const bool conformal : { true, false })
  {
    Points2 map = conformal ? leastSquaresConformalMap(mesh, {}, context.execution).positions
                            : embedConvexly(mesh, context.execution);
    if (map.empty() || countFlipped(mesh, map) > 0)
    {
      continue;
    }
    // |J|^2 of the map s times as large is s^2 times as large, |J^-1|^2 is divided by it.
    double stretching = 0.0;
    double pressing = 0.0;
    for (const Triangle& c : mesh.triangles())
    {
      const TriangleFrame frame(mesh.points(), c);
      const Eigen::Vector4d parts = mapParts(frame, c, [&map](Index v) { return map[v]; });
      const double norm = 0.5 * parts.squaredNorm();
      stretching += frame.area * norm;
      pressing += frame.area * (distortionEnergyDensity({ barrier }, parts) + 4.0 - norm);
    }
    const double energy = 2.0 * std::sqrt(stretching * pressing) / mesh.area();
    if (energy < least)
    {
      least = energy;
      const double size = std::pow(pressing / stretching, 0.25);
      std::transform(
        map.begin(), map.end(), map.begin(), [size](const Point2& q) { return Point2(size * q); });
      best = std::move(map);
    }
    if (least < goodStart)
    {
      break;
    }
  }
  return best;
}

bool keepsWires(const PieceSolution& piece)
{
  return !piece.isometric->history.empty() &&
    piece.isometric->history.back().constraint < wiresKeptWithin;
}

MapDistortion quality(const PieceContext& context, const PieceSolution& piece)
{
  return measureDistortion(context.piece.mesh, piece.positions, context.execution);
}

/// Whether triangles are pressed so much more than others that next to nothing is left of them.
bool collapses(const MapDistortion& summary)
{
  return summary.globalHomogeneity < nearlyCollapsed;
}

std::size_t overlaps(const PieceContext& context, const PieceSolution& piece)
{
  return countBoundaryOverlaps(context.piece.mesh, piece.positions, fewListed).count;
}

/// The piece as the isometric scheme has put it from a convex start.
PieceSolution placedBy(
  IsometricSolution solution, DistortionEnergyKind kind, const PieceSolution& wires)
{
  PieceSolution piece = wires;
  piece.factorizations = solution.factorizations;
  piece.report.energyUsed = kind;
  piece.fromConvexStart = true;
  piece.placement = solution.status;
  piece.positions = solution.positions;
  piece.isometric = std::move(solution);
  return piece;
}

/// The isometric scheme with an energy that does not fold more than its start does.
IsometricSolution warpWithoutFolding(
  const PieceContext& context, const IsometricOptions& asked, PieceSolution& piece)
{
  const Execution execution = context.execution.part(0.2, 1.0);
  const auto warp = [&](const IsometricOptions& options) {
    piece.report.energyUsed = options.energy.kind;
    IsometricSolution solution = warpIsometrically(
      context.piece, piece.problem, piece.positions, piece.angles.stretch, options, execution);
    piece.factorizations += solution.factorizations;
    return solution;
  };
  const Index flippedBefore = countFlipped(context.piece.mesh, piece.positions);
  const auto worse = [&](const IsometricSolution& candidate) {
    return !candidate.status.refused() &&
      (countFlipped(context.piece.mesh, candidate.positions) > flippedBefore ||
        !std::isfinite(candidate.distortionEnergy));
  };
  IsometricSolution solution = warp(asked);
  if (worse(solution) && flippedBefore == 0)
  {
    // From a start without flips the energy with a barrier keeps it so.
    IsometricOptions withBarrier = asked;
    withBarrier.energy.kind = DistortionEnergyKind::SymmetricDirichlet;
    solution = warp(withBarrier);
  }
  if (worse(solution))
  {
    // The start is the best that is known; its energy is finite without a barrier only.
    IsometricOptions still = asked;
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
void untangleAfter(const PieceContext& context, PieceSolution& piece)
{
  const Index flipped = countFlipped(context.piece.mesh, piece.positions);
  if (flipped == 0)
  {
    return;
  }
  Points2 positions = piece.positions;
  const UntanglingResult untangled =
    untangleInterior(context.piece, context.network, context.execution, positions);
  if (untangled.status.refused())
  {
    piece.placement = untangled.status;
  }
  else if (countFlipped(context.piece.mesh, positions) < flipped)
  {
    piece.positions = std::move(positions);
  }
}

/// First without the shapes of key curves.
IsometricSolution warpFromConvexMap(const PieceContext& context, const PieceSolution& wires,
  const Points2& start, const IsometricOptions& options, const Execution& execution)
{
  AngleProblem unlocked = wires.problem;
  unlocked.locks = freeNodes(context.network);
  const std::vector<double> rigid(wires.problem.groups.size(), 0.0);
  IsometricSolution solution = warpByPenaltyContinuation(
    context.piece, unlocked, bent(context.piece.mesh, start), rigid, options, execution);
  if (!solution.status.refused() && wires.locks())
  {
    const int before = solution.factorizations;
    solution = warpByPenaltyContinuation(
      context.piece, wires.problem, solution.positions, solution.stretch, options, execution);
    solution.factorizations += before;
  }
  return solution;
}

AngleProblem withoutWires(const PieceContext& context, const PieceSolution& wires)
{
  AngleProblem bare = wires.problem;
  bare.locks = freeNodes(context.network);
  bare.held.assign(bare.held.size(), 0);
  return bare;
}

bool holdsAny(const AngleProblem& problem)
{
  return std::find(problem.held.begin(), problem.held.end(), 1) != problem.held.end();
}

/// A vertex lies where the mean of its triangles has it.
Points2 givenStart(const PieceContext& context)
{
  const TriangleMesh& mesh = context.piece.mesh;
  Points2 positions(mesh.vertexCount(), Point2::Zero());
  std::vector<double> count(mesh.vertexCount(), 0.0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const FlatCorners& corners =
      context.options.start[context.cut.originalTriangle(context.piece.triangles[t])];
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      const Index v = mesh.triangle(t)[k];
      positions[v] += corners[k];
      count[v] += 1.0;
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    positions[v] /= count[v];
  }
  return positions;
}

/// Without overlap, from a start without any or from a convex map on, and without wires at first.
/// No value: that map folds.
std::optional<IsometricSolution> warpApart(const PieceContext& context, const PieceSolution& wires,
  const IsometricOptions& options, const Execution& execution)
{
  const TriangleMesh& mesh = context.piece.mesh;
  const auto isApart = [&mesh](const Points2& map) {
    return !map.empty() && countFlipped(mesh, map) == 0 &&
      findBoundaryOverlaps(mesh, map, fewListed).empty();
  };
  Points2 start = context.options.start.empty() ? Points2() : givenStart(context);
  if (!start.empty() && countFlipped(mesh, start) > 0)
  {
    untangleInterior(context.piece, context.network, context.execution, start);
  }
  start = isApart(start) ? std::move(start) : embedConvexly(mesh, context.execution);
  if (!isApart(start))
  {
    return std::nullopt;
  }
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles())
  {
    area += 0.5 * cross(start[b] - start[a], start[c] - start[a]);
  }
  const double scale = std::sqrt(mesh.area() / area);
  for (Point2& point : start)
  {
    point *= scale;
  }
  IsometricSolution solution = warpWithoutOverlap(context.piece, withoutWires(context, wires),
    start, context.options.enoughStrain, options, execution);
  if (!solution.status.refused() && holdsAny(wires.problem))
  {
    const int before = solution.factorizations;
    solution =
      warpWithoutOverlap(context.piece, wires.problem, solution.positions, 0.0, options, execution);
    solution.factorizations += before;
  }
  return solution;
}

/// First without any wire, then with those that are held.
IsometricSolution warpFreely(const PieceContext& context, const PieceSolution& wires,
  const Points2& start, const IsometricOptions& options, const Execution& execution)
{
  const AngleProblem bare = withoutWires(context, wires);
  const std::vector<double> rigid(wires.problem.groups.size(), 0.0);
  IsometricSolution solution =
    warpIsometrically(context.piece, bare, start, rigid, options, execution);
  if (solution.status.refused() || !holdsAny(wires.problem))
  {
    return solution;
  }
  int before = solution.factorizations;
  const Points2 free = std::move(solution.positions);
  solution = warpIsometrically(context.piece, wires.problem, free, rigid, options, execution);
  if (solution.status.code == StatusCode::NotConverged)
  {
    before += solution.factorizations;
    solution =
      warpByPenaltyContinuation(context.piece, wires.problem, free, rigid, options, execution);
  }
  solution.factorizations += before;
  return solution;
}

/// From where the wires' angles have put the piece; what it folds is untangled.
void warpPlacedPiece(
  const PieceContext& context, const IsometricOptions& options, PieceSolution& piece)
{
  piece.isometric = warpWithoutFolding(context, options, piece);
  if (piece.isometric->status.ok() && piece.placement.code == StatusCode::NotConverged)
  {
    piece.placement = {}; // of an interior that was only the start
  }
  noteStatus(piece.isometric->status, piece.placement);
  if (!piece.isometric->status.refused())
  {
    piece.positions = piece.isometric->positions;
  }
  if (!piece.placement.refused())
  {
    untangleAfter(context, piece);
  }
}

/// Whether the isometric scheme's result may have been led astray by its start: it is folded, has
/// triangles that nearly collapse, is not at a minimum, or far from isometric.
bool isDoubtful(const PieceContext& context, const PieceSolution& piece)
{
  const bool otherEnergy = piece.report.energyUsed != context.options.isometric.energy.kind;
  if (otherEnergy || piece.isometric->status.code == StatusCode::NotConverged ||
    countFlipped(context.piece.mesh, piece.positions) > 0)
  {
    return true;
  }
  const MapDistortion summary = quality(context, piece);
  return summary.rigidEnergy > farFromIsometric || collapses(summary);
}

/// Whether to prefer the second to the first: fewer folds, then wires as asked for, no overlap, no
/// triangle that nearly collapses, then less distortion, by more than a percent, then a minimum,
/// and one that is not found after very many steps.
bool isBetter(const PieceContext& context, const PieceSolution& second, const PieceSolution& first)
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
    return second.placement.ok() && (!first.placement.ok() || late);
  }
  return other.rigidEnergy < one.rigidEnergy;
}
}

void warpPiece(const PieceContext& context, PieceSolution& piece)
{
  // On a cloth the result is only where its own solution starts.
  const std::optional<ClothOptions>& cloth = context.options.cloth;
  IsometricOptions options = context.options.isometric;
  options.rough = options.rough || (cloth && !cloth->material.isotropic);
  warpPlacedPiece(context, options, piece);
  if (piece.placement.refused() || !isDoubtful(context, piece))
  {
    return;
  }
  std::optional<PieceSolution> second = warpFromConvexStart(context, piece, options);
  if (!second)
  {
    return;
  }
  piece.factorizations += second->factorizations;
  second->factorizations = piece.factorizations;
  // Keys that keep it from a minimum had better be released.
  if ((second->placement.ok() || !piece.locks()) && isBetter(context, *second, piece))
  {
    piece = std::move(*second);
  }
}

std::optional<PieceSolution> warpFromConvexStart(
  const PieceContext& context, const PieceSolution& wires, const IsometricOptions& asked)
{
  const bool free = wires.rules.freeBoundary;
  const bool prevented = free && context.options.preventOverlap;
  const Execution execution = context.execution.part(1.0, 1.0);
  const IsometricOptions options = optionsWithBarrier(asked);
  if (prevented && context.options.enoughStrain > 0.0)
  {
    std::optional<IsometricSolution> apart = warpApart(context, wires, options, execution);
    if (apart)
    {
      return apart->status.refused() ? std::nullopt
                                     : std::optional(placedBy(std::move(*apart), barrier, wires));
    }
  }
  const Points2 start =
    free ? unfoldedMap(context) : embedConvexly(context.piece.mesh, context.execution);
  if (start.empty() || countFlipped(context.piece.mesh, start) > 0)
  {
    return std::nullopt;
  }
  IsometricSolution solution = free ? warpFreely(context, wires, start, options, execution)
                                    : warpFromConvexMap(context, wires, start, options, execution);
  if (solution.status.refused())
  {
    return std::nullopt;
  }
  PieceSolution placed = placedBy(std::move(solution), barrier, wires);
  if (asked.energy.kind != barrier && quality(context, placed).rigidEnergy < surelyFolding)
  {
    IsometricSolution last = warpByPenaltyContinuation(
      context.piece, wires.problem, placed.positions, placed.isometric->stretch, asked, execution);
    if (last.status.refused())
    {
      return std::nullopt;
    }
    const bool folds = countFlipped(context.piece.mesh, last.positions) > 0;
    PieceSolution other = placedBy(std::move(last), asked.energy.kind, wires);
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
  if (prevented && overlaps(context, placed) > 0)
  {
    std::optional<IsometricSolution> apart = warpApart(context, wires, options, execution);
    if (apart && apart->status.code == StatusCode::Cancelled)
    {
      return std::nullopt;
    }
    if (apart)
    {
      apart->factorizations += placed.factorizations;
      placed = placedBy(std::move(*apart), barrier, wires);
    }
  }
  return placed;
}

std::optional<PieceSolution> warpFromGivenStart(
  const PieceContext& context, const CurveRules& rules)
{
  const FlatteningOptions& options = context.options;
  if (options.start.empty() || options.scheme != Scheme::Isometric || options.cloth ||
    options.preventOverlap)
  {
    return std::nullopt;
  }
  PieceSolution flat;
  flat.rules = rules;
  flat.problem =
    makeWireProblem(context.network, context.piece, context.cut, context.curves, rules);
  if (flat.locks() || !flat.problem.groups.empty())
  {
    return std::nullopt;
  }
  const Points2 start = givenStart(context);
  if (countFlipped(context.piece.mesh, start) > 0)
  {
    return std::nullopt;
  }
  flat.angles.theta = planarAngles(flat.problem, start);
  flat.angles.length = flat.problem.length;
  IsometricSolution solution =
    warpIsometrically(context.piece, flat.problem, start, {}, options.isometric, context.execution);
  if (!solution.status.ok() || countFlipped(context.piece.mesh, solution.positions) > 0)
  {
    return std::nullopt;
  }
  flat.positions = solution.positions;
  flat.isometric = std::move(solution);
  flat.report.energyUsed = options.isometric.energy.kind;
  flat.fromGivenStart = true;
  return flat;
}
}
