// SPDX-License-Identifier: BSD-3-Clause
#include "PieceFlattening.h"

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
/// How far a connector may go from its length on the surface, and what elastic lengths cost: little,
/// so that the angles decide.
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

/// Host vertices of the status's nodes, as vertices of the cut surface.
void nodesToVertices(const WireNetwork& network, const Piece& piece, Status& status)
{
  for (Index& id : status.ids)
  {
    id = piece.vertices[network.vertex[id]];
  }
  status.ids.erase(std::unique(status.ids.begin(), status.ids.end()), status.ids.end());
}

void solveWires(const Piece& piece, const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution, FlatPiece& result)
{
  const WireNetwork& network = result.network;
  PieceReport& report = result.report;
  auto solve = [&](const NodeLocks& locks) {
    AngleProblem problem = makeAngleProblem(network, locks);
    addStretchGroups(network, curves, problem);
    problem.alternativeStart = [&] { return conformalStart(piece, network); };
    if (options.scheme != Scheme::Progressive)
    {
      return solveAngles(problem, options.angles, execution);
    }
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
    for (Index loop : progressive.warpingOrder)
    {
      report.warpingOrder.push_back(network.patchOfLoop[loop]);
    }
    progressive.angles.stretch = elastic.stretch;
    return progressive.angles;
  };

  NodeLocks locks = lockKeyCurves(network, piece, cut, curves);
  if (options.releaseKeys)
  {
    std::fill(locks.locked.begin(), locks.locked.end(), 0);
    locks.lockedCount = 0;
  }
  const AngleConstraints constraints(makeAngleProblem(network, locks));
  report.freeWireNodes = constraints.freeCount();
  report.constraints = constraints.rowCount();

  AngleSolution solution = solve(locks);
  if (!solution.status.ok() && locks.lockedCount > 0 &&
    solution.status.code != StatusCode::Cancelled)
  {
    report.warpingOrder.clear();
    KeyRelease release = releaseKeys(network, piece, cut, curves, solution, solve);
    solution = std::move(release.solution);
    report.status = std::move(release.status);
  }
  if (report.status.ok())
  {
    report.status = solution.status;
    nodesToVertices(network, piece, report.status);
  }
  report.iterations = solution.iterations;
  report.objective = solution.objective;
  report.closureResidual = solution.closure;
  report.history = std::move(solution.history);
  if (report.status.refused())
  {
    return;
  }
  WireLayout layout = layOutWires(network, solution.theta, solution.length);
  result.positions = std::move(layout.positions);
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
  solveWires(piece, cut, curves, options, execution, result);
  result.secondsWires = watch.restart();
  if (report.status.refused())
  {
    return result;
  }
  const InteriorResult interior =
    embedInterior(piece, result.network, options.interior, execution, result.positions);
  if (!interior.status.ok())
  {
    report.status = interior.status;
  }
  result.secondsInterior = watch.restart();
  return result;
}
}
