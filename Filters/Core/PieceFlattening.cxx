// SPDX-License-Identifier: BSD-3-Clause
#include "PieceFlattening.h"

#include "FoldoverFree.h"
#include "KeyRelease.h"
#include "ProgressiveWarping.h"
#include "Stopwatch.h"
#include "WireLayout.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// How far a connector may go from its length on the surface, and what elastic lengths cost:
/// little, so that the angles decide.
constexpr double connectorTolerance = 0.9;
constexpr double stretchWeight = 1e-2;

/// Elastic curves stretch as one, each edge of a connector on its own.
void addStretchGroups(
  const WireNetwork& network, const std::vector<FeatureCurve>& curves, AngleProblem& problem)
{
  Indices groupOfCurve(curves.size(), none);
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    if (edge.connector)
    {
      problem.stretchGroup[e] = static_cast<Index>(problem.groups.size());
      problem.groups.push_back({ connectorTolerance, stretchWeight });
    }
    else if (edge.curve != none && curves[edge.curve].tolerance > 0.0)
    {
      Index& group = groupOfCurve[edge.curve];
      if (group == none)
      {
        group = static_cast<Index>(problem.groups.size());
        problem.groups.push_back({ curves[edge.curve].tolerance, 0.0 });
      }
      problem.stretchGroup[e] = group;
      problem.groups[group].weight += stretchWeight;
    }
  }
}

/// Angles and lengths of the wires in a conformal map, to start from where the plain start fails.
AngleStart conformalStart(const Piece& piece, const WireNetwork& network)
{
  AngleStart start;
  start.theta = network.alpha;
  for (const WireEdge& edge : network.edges)
  {
    start.length.push_back(edge.length);
  }
  const ConformalMap map = mapConformally(piece.mesh, {});
  if (!map.status.ok())
  {
    return start;
  }
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    start.length[e] = (map.positions[edge.to] - map.positions[edge.from]).norm();
  }
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    const Point2& at = map.positions[network.vertex[i]];
    const Point2 in = at - map.positions[network.vertex[network.previous[i]]];
    const Point2 out = map.positions[network.endVertex(i)] - at;
    const bool tip = network.edge[i] == network.edge[network.previous[i]];
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    start.theta[i] = tip ? 2.0 * pi : pi - turn;
  }
  return start;
}

/// The wires' problem as it was solved in the end, and its solution.
struct WireSolution
{
  AngleProblem problem;
  AngleSolution angles;
};

AngleSolution solveProgressively(AngleProblem problem, const FlatteningOptions& options,
  const Execution& execution, PieceReport& report)
{
  AngleSolution elastic;
  if (!problem.groups.empty())
  {
    // Lengths that may change are chosen for the piece as a whole, then warped patch by patch.
    elastic = solveAngles(problem, options.angles, execution);
    if (!elastic.status.ok())
    {
      return elastic;
    }
    problem.length = elastic.length;
    problem.groups.clear();
    problem.stretchGroup.assign(problem.stretchGroup.size(), none);
  }
  ProgressiveSolution progressive = warpProgressively(problem, options.angles, execution);
  report.warpingOrder.clear();
  for (Index loop : progressive.warpingOrder)
  {
    report.warpingOrder.push_back(problem.network->patchOfLoop[loop]);
  }
  progressive.angles.stretch = elastic.stretch;
  return progressive.angles;
}

WireSolution solveWires(const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const Execution& execution, FlatPiece& result)
{
  const WireNetwork& network = result.network;
  PieceReport& report = result.report;
  auto pose = [&](NodeLocks locks) {
    AngleProblem problem = makeAngleProblem(network, std::move(locks));
    addStretchGroups(network, curves, problem);
    problem.alternativeStart = [&piece, &network] { return conformalStart(piece, network); };
    return problem;
  };
  auto solve = [&](const NodeLocks& locks) {
    AngleProblem problem = pose(locks);
    return options.scheme == Scheme::Progressive
      ? solveProgressively(std::move(problem), options, execution, report)
      : solveAngles(problem, options.angles, execution);
  };

  NodeLocks locks = lockKeyCurves(network, piece, cut, curves);
  if (options.releaseKeys)
  {
    std::fill(locks.locked.begin(), locks.locked.end(), 0);
    locks.lockedCount = 0;
  }
  WireSolution wires{ pose(locks), solve(locks) };
  const AngleConstraints constraints(wires.problem);
  report.freeWireNodes = constraints.freeCount();
  report.constraints = constraints.rowCount();
  if (!wires.angles.status.ok() && locks.lockedCount > 0 &&
    wires.angles.status.code != StatusCode::Cancelled)
  {
    KeyRelease release = releaseKeys(network, piece, cut, curves, wires.angles, solve);
    wires.problem = pose(std::move(release.locks));
    wires.angles = std::move(release.solution);
    report.status = std::move(release.status);
    if (options.scheme == Scheme::Progressive && !release.released.empty())
    {
      // The report's order of warping is that of the last solve, so let it be this one.
      wires.angles = solve(wires.problem.locks);
      if (wires.angles.status.refused())
      {
        report.status = wires.angles.status;
      }
    }
  }
  if (report.status.ok())
  {
    report.status = wires.angles.status;
  }
  report.iterations = wires.angles.iterations;
  report.objective = wires.angles.objective;
  report.closureResidual = wires.angles.closure;
  report.history = wires.angles.history;
  if (options.scheme != Scheme::Progressive && !report.status.refused())
  {
    const bool poor = !report.status.ok() ||
      largestAngleChange(wires.problem, wires.angles.theta) > poorAngleChange;
    report.advice =
      adviseRelease(network, piece, cut, curves, wires.angles, options.angles, poor, execution);
  }
  return wires;
}

Index countFlipped(const TriangleMesh& mesh, const Points2& positions)
{
  Index count = 0;
  for (const Triangle& c : mesh.triangles())
  {
    const Point2 u = positions[c[1]] - positions[c[0]];
    const Point2 v = positions[c[2]] - positions[c[0]];
    count += u.x() * v.y() - u.y() * v.x() > 0.0 ? 0 : 1;
  }
  return count;
}

/// The isometric scheme from where the global scheme and the pinned interior have put the piece.
void warpPieceIsometrically(const Piece& piece, const WireSolution& wires,
  const FlatteningOptions& options, const Execution& execution, FlatPiece& result)
{
  auto warp = [&](const IsometricOptions& isometric) {
    return warpIsometrically(
      piece, wires.problem, result.positions, wires.angles.stretch, isometric, execution);
  };
  IsometricSolution solution = warp(options.isometric);
  if (!solution.status.refused() &&
    countFlipped(piece.mesh, solution.positions) > countFlipped(piece.mesh, result.positions))
  {
    // From a start without flips the energy with a barrier keeps it so.
    IsometricOptions barrier = options.isometric;
    barrier.energy.kind = SheetEnergyKind::SymmetricDirichlet;
    IsometricSolution second = warp(barrier);
    if (second.status.refused() ||
      countFlipped(piece.mesh, second.positions) < countFlipped(piece.mesh, solution.positions))
    {
      solution = std::move(second);
    }
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
  report.sheetEnergy = solution.sheetEnergy;
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

void mapPieceConformally(
  const Piece& piece, const CutSurface& cut, const FlatteningOptions& options, FlatPiece& result)
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
  ConformalMap map = mapConformally(piece.mesh, conformal);
  result.positions = std::move(map.positions);
  result.report.status = std::move(map.status);
}
}

FlatPiece flattenPiece(const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const Execution& execution)
{
  Stopwatch watch;
  FlatPiece result;
  result.network = buildWireNetwork(piece);
  PieceReport& report = result.report;
  report.triangles = piece.mesh.triangleCount();
  report.vertices = piece.mesh.vertexCount();
  report.wirePatches = result.network.patchCount;
  report.wireNodes = result.network.nodeCount();
  report.freeWireNodes = result.network.nodeCount();
  report.status = result.network.status;
  if (report.status.refused())
  {
    return result;
  }
  if (options.scheme == Scheme::Conformal)
  {
    mapPieceConformally(piece, cut, options, result);
    result.secondsInterior = watch.restart();
    return result;
  }
  const WireSolution wires = solveWires(piece, cut, curves, options, execution, result);
  if (!report.status.refused())
  {
    result.positions =
      layOutWires(result.network, wires.angles.theta, wires.angles.length).positions;
  }
  result.secondsWires = watch.restart();
  if (report.status.refused())
  {
    return result;
  }
  const InteriorResult interior =
    embedInterior(piece, result.network, options.interior, execution, result.positions);
  if (!interior.status.ok() && (report.status.ok() || interior.status.refused()))
  {
    report.status = interior.status;
  }
  if (options.interior.method == InteriorMethod::AsRigidAsPossible && !report.status.refused())
  {
    const UntanglingResult untangled =
      untangleInterior(piece, result.network, execution, result.positions);
    if (!untangled.status.ok())
    {
      report.status = untangled.status;
    }
  }
  if (options.scheme == Scheme::Isometric && !report.status.refused())
  {
    warpPieceIsometrically(piece, wires, options, execution, result);
  }
  result.secondsInterior = watch.restart();
  return result;
}
}
