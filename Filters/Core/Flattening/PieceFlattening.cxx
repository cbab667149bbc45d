// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceFlattening.h"

#include "Base/Stopwatch.h"
#include "Cut/CutClosure.h"
#include "Embedding/ConformalMap.h"
#include "Embedding/Untangling.h"
#include "Embedding/WireLayout.h"
#include "Flattening/PieceWires.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// The isometric scheme from where the global scheme and the pinned interior have put the piece.
void warpPieceIsometrically(const Piece& piece, const WireSolution& wires,
  const FlatteningOptions& options, const Execution& execution, FlatPiece& result)
{
  auto warp = [&](const IsometricOptions& isometric) {
    return warpIsometrically(
      piece, wires.problem, result.positions, wires.angles.stretch, isometric, execution);
  };
  IsometricSolution solution = warp(options.isometric);
  const Index flippedBefore = countFlipped(piece.mesh, result.positions);
  const auto worse = [&](const IsometricSolution& candidate) {
    return !candidate.status.refused() &&
      (countFlipped(piece.mesh, candidate.positions) > flippedBefore ||
        !std::isfinite(candidate.distortionEnergy));
  };
  if (worse(solution) && flippedBefore == 0)
  {
    // From a start without flips the energy with a barrier keeps it so.
    IsometricOptions barrier = options.isometric;
    barrier.energy.kind = DistortionEnergyKind::SymmetricDirichlet;
    solution = warp(barrier);
  }
  if (worse(solution))
  {
    // The start is the best that is known; its energy is finite without a barrier only.
    IsometricOptions still = options.isometric;
    still.maximumIterations = 0;
    still.energy.kind = DistortionEnergyKind::AsRigidAsPossible;
    solution = warp(still);
    solution.status = { StatusCode::NotConverged,
      "the isometric scheme found nothing better than where the wires' own angles put the piece; "
      "mend slivers there",
      {} };
  }
  PieceReport& report = result.report;
  for (const IsometricIteration& iteration : solution.history)
  {
    IterationRecord record;
    record.phase = iteration.exact ? "isometric" : "isometric, convex";
    record.objective = iteration.energy;
    record.closure = iteration.constraint;
    record.optimality = iteration.optimality;
    record.step = iteration.step;
    report.history.push_back(record);
  }
  report.iterations = solution.iterations;
  report.distortionEnergy = solution.distortionEnergy;
  report.angleEnergy = solution.angleEnergy;
  if (!solution.status.ok() && (report.status.ok() || solution.status.refused()))
  {
    report.status = solution.status;
  }
  if (!solution.status.refused())
  {
    result.positions = std::move(solution.positions);
  }
}

/// What the isometric scheme left flipped, with the wires where it has put them.
void untangleAfter(
  const Piece& piece, const WireNetwork& network, const Execution& execution, FlatPiece& result)
{
  if (result.report.status.refused())
  {
    return;
  }
  const Index flipped = countFlipped(piece.mesh, result.positions);
  if (flipped == 0)
  {
    return;
  }
  Points2 positions = result.positions;
  const UntanglingResult untangled = untangleInterior(piece, network, execution, positions);
  if (untangled.status.refused())
  {
    result.report.status = untangled.status;
  }
  else if (countFlipped(piece.mesh, positions) < flipped)
  {
    result.positions = std::move(positions);
  }
}

void mapPieceConformally(const Piece& piece, const CutSurface& cut,
  const FlatteningOptions& options, const Execution& execution, FlatPiece& result)
{
  ConformalOptions conformal = options.conformal;
  for (Index& pin : conformal.pins)
  {
    // The first copy of the pinned vertex in this piece.
    const auto copy = std::find_if(piece.vertices.begin(), piece.vertices.end(),
      [&](Index v) { return pin != none && cut.originalVertex[v] == pin; });
    pin = copy == piece.vertices.end() ? none : static_cast<Index>(copy - piece.vertices.begin());
  }
  if (conformal.pins[0] == none || conformal.pins[1] == none)
  {
    conformal.pins = { none, none };
  }
  ConformalMap map = mapConformally(piece.mesh, conformal, execution);
  result.positions = std::move(map.positions);
  result.report.status = std::move(map.status);
}

/// Positions from the wires' angles to the whole piece. The report gets what each stage says.
void placePiece(WiredPiece& wired, const WireSolution& wires, const FlatteningOptions& options,
  const Execution& execution, bool keep, FlatPiece& result)
{
  const Piece& piece = wired.piece;
  const WireNetwork& network = *wired.network;
  Stopwatch watch;
  PieceReport& report = result.report;
  report.status = wires.status;
  if (report.status.refused())
  {
    return;
  }
  execution.report(0.1, "Placing the interior");
  result.positions = layOutWires(network, wires.angles.theta, wires.angles.length).positions;
  result.secondsWires += watch.restart();
  const InteriorResult interior = embedInterior(piece, network, options.interior, execution,
    result.positions, keep ? &wired.interiors : nullptr);
  if (!interior.status.ok() && (report.status.ok() || interior.status.refused()))
  {
    report.status = interior.status;
  }
  if (options.interior.method == InteriorMethod::AsRigidAsPossible && !report.status.refused())
  {
    const UntanglingResult untangled =
      untangleInterior(piece, network, execution, result.positions);
    if (!untangled.status.ok())
    {
      report.status = untangled.status;
    }
  }
  if (options.scheme == Scheme::Isometric && !report.status.refused())
  {
    warpPieceIsometrically(piece, wires, options, execution.part(0.2, 1.0), result);
    untangleAfter(piece, network, execution, result);
  }
  result.secondsInterior += watch.restart();
}

void reportWires(const WireSolution& wires, PieceReport& report)
{
  report.status = wires.status;
  report.warpingOrder = wires.warpingOrder;
  report.iterations = wires.angles.iterations;
  report.objective = wires.angles.objective;
  report.closureResidual = wires.angles.closure;
  report.history = wires.angles.history;
  report.released = wires.released;
}

/// Key shapes that can be met, but only by wires that fold triangles over, count as incompatible.
void releaseFoldingKeys(WiredPiece& wired, const PieceWires& pieceWires,
  const FlatteningOptions& options, const Execution& execution, bool keep, WireSolution& wires,
  FlatPiece& result)
{
  const TriangleMesh& mesh = wired.piece.mesh;
  const bool folds = wires.status.ok() && wires.problem.locks.lockedCount > 0 &&
    options.interior.method == InteriorMethod::AsRigidAsPossible &&
    !result.report.status.refused() && countFlipped(mesh, result.positions) > 0;
  if (!folds)
  {
    return;
  }
  FlatteningOptions pinned = options;
  pinned.scheme = Scheme::Global;
  const auto liesFlat = [&](const WireSolution& candidate) {
    FlatPiece trial;
    placePiece(wired, candidate, pinned, execution, keep, trial);
    return !trial.report.status.refused() && countFlipped(mesh, trial.positions) == 0;
  };
  WireSolution released = pieceWires.release(wires, liesFlat);
  if (released.status.code == StatusCode::IncompatibleKeys)
  {
    wires = std::move(released);
    reportWires(wires, result.report);
    placePiece(wired, wires, options, execution, keep, result);
  }
}

FlatPiece flattenAsCut(WiredPiece& wired, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const Execution& execution, bool keep)
{
  Stopwatch watch;
  const Piece& piece = wired.piece;
  if (!wired.network)
  {
    wired.network = buildWireNetwork(piece);
  }
  const WireNetwork& network = *wired.network;
  FlatPiece result;
  PieceReport& report = result.report;
  report.triangles = piece.mesh.triangleCount();
  report.vertices = piece.mesh.vertexCount();
  report.wirePatches = network.patchCount;
  report.wireNodes = network.nodeCount();
  report.freeWireNodes = network.nodeCount();
  report.boundaryLoops = static_cast<Index>(piece.mesh.boundaryLoops().size());
  report.wired = std::any_of(piece.curveOfHalfedge.begin(), piece.curveOfHalfedge.end(),
    [](Index curve) { return curve != none; });
  report.status = network.status;
  if (report.status.refused())
  {
    return result;
  }
  if (options.scheme == Scheme::Conformal)
  {
    mapPieceConformally(piece, cut, options, execution, result);
    result.secondsInterior = watch.restart();
    return result;
  }
  const PieceWires pieceWires(piece, network, cut, curves, options, execution);
  WireSolution wires = pieceWires.solve();
  const AngleConstraints constraints(wires.problem);
  report.freeWireNodes = constraints.freeCount();
  report.constraints = constraints.rowCount();
  reportWires(wires, report);
  result.secondsWires = watch.restart();
  placePiece(wired, wires, options, execution, keep, result);
  releaseFoldingKeys(wired, pieceWires, options, execution, keep, wires, result);
  if (options.scheme != Scheme::Progressive && !report.status.refused())
  {
    watch.restart();
    // The Laplacian interior distorts by itself, whatever the wires.
    const bool poor = options.interior.method == InteriorMethod::AsRigidAsPossible &&
      liesPoorly(piece.mesh, result.positions);
    report.advice = pieceWires.advise(wires, poor);
    result.secondsWires += watch.restart();
  }
  return result;
}

/// Takes over a flattening of the piece with some vertices joined.
void takeOver(FlatPiece joined, WireNetwork network, const Indices& place, FlatPiece& result)
{
  Indices vertexOf(joined.positions.size());
  for (std::size_t v = 0; v < place.size(); ++v)
  {
    vertexOf[place[v]] = static_cast<Index>(v);
    result.positions[v] = joined.positions[place[v]];
  }
  for (WireEdge& edge : network.edges)
  {
    edge.from = vertexOf[edge.from];
    edge.to = vertexOf[edge.to];
  }
  joined.report.vertices = result.report.vertices;
  result.joinedNetwork = std::move(network);
  result.report = std::move(joined.report);
}

void closeCuts(const Piece& piece, const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution, FlatPiece& result)
{
  const Index flipped = countFlipped(piece.mesh, result.positions);
  WiredPiece joinedWired;
  FlatPiece joinedFlat;
  Indices place;
  const auto flatten = [&](const Indices& joined) {
    JoinedPiece joinedPiece = joinVertices(piece, joined);
    joinedWired = {};
    joinedWired.piece = std::move(joinedPiece.piece);
    joinedFlat = flattenAsCut(joinedWired, cut, curves, options, execution.part(1.0, 1.0), false);
    result.secondsWires += joinedFlat.secondsWires;
    result.secondsInterior += joinedFlat.secondsInterior;
    place = std::move(joinedPiece.place);
    Points2 positions;
    const Status& status = joinedFlat.report.status;
    const bool good = (status.ok() || status.code == result.report.status.code) &&
      countFlipped(joinedWired.piece.mesh, joinedFlat.positions) <= flipped;
    for (std::size_t v = 0; good && v < place.size(); ++v)
    {
      positions.push_back(joinedFlat.positions[place[v]]);
    }
    return positions;
  };
  const CutClosure closure = closeCrossingCuts(piece, cut, result.positions, flatten);
  if (joinedFlat.report.status.code == StatusCode::Cancelled)
  {
    result.report.status = joinedFlat.report.status;
  }
  else if (closure.closed && !closure.edges.empty())
  {
    takeOver(std::move(joinedFlat), std::move(*joinedWired.network), place, result);
    for (Index h : closure.edges)
    {
      result.report.closedEdges.push_back(3 * piece.triangles[h / 3] + h % 3);
    }
    std::sort(result.report.closedEdges.begin(), result.report.closedEdges.end());
  }
}
}

FlatPiece flattenPiece(WiredPiece& wired, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const Execution& execution, bool keep)
{
  FlatPiece result = flattenAsCut(wired, cut, curves, options, execution, keep);
  if (options.closeCuts && !result.report.status.refused())
  {
    closeCuts(wired.piece, cut, curves, options, execution, result);
  }
  return result;
}
}
