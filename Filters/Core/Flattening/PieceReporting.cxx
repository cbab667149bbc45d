// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceReporting.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// The largest relative error of a wire edge against the length that was solved for, which is that
/// on the surface but where it is free.
double largestLengthError(const PieceContext& context, const FlatWires& flat)
{
  const WireNetwork& network = context.network;
  const AngleProblem& problem = flat.wires.problem;
  double worst = 0.0;
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    double asked = flat.wires.angles.length[e];
    if (flat.placed.isometric)
    {
      const Index group = problem.stretchGroup[e];
      asked =
        problem.length[e] * (group == none ? 1.0 : 1.0 + flat.placed.isometric->stretch[group]);
    }
    // The isometric scheme leaves connectors as long as they come.
    if (!(edge.connector && flat.placed.isometric))
    {
      const double length =
        (flat.placed.positions[edge.to] - flat.placed.positions[edge.from]).norm();
      worst = std::max(worst, std::abs(length - asked) / asked);
    }
  }
  return worst;
}

/// A bend of 2 % turns the ends of a curve by 5 degrees from its line, the least that pattern
/// makers tell from the straight grain; a line along mesh edges may waver by as much.
constexpr double straightGrain = 0.02;

/// See PieceReport::otherEnergy.
std::string otherEnergy(const PieceContext& context, const FlatWires& flat)
{
  if (!flat.placed.isometric || flat.placed.clothSolved ||
    flat.placed.energyUsed == context.options.isometric.energy.kind)
  {
    return {};
  }
  return flat.placed.energyUsed == DistortionEnergyKind::SymmetricDirichlet
    ? "the symmetric Dirichlet energy was used: the one asked for folds triangles, or presses them "
      "to nothing"
    : "no energy of the isometric scheme keeps triangles from folding; the piece lies where the "
      "global scheme has put it";
}

/// What was done in place of what was asked for.
std::vector<std::string> fallbacks(const PieceContext& context, const FlatWires& flat)
{
  std::vector<std::string> all;
  const FlatteningOptions& options = context.options;
  if (options.angles.method == AngleMethod::Sequential &&
    flat.wires.angles.method == AngleMethod::Newton)
  {
    all.emplace_back("the wires were solved by Newton's method: the sequential one of the paper "
                     "cannot choose the lengths of elastic curves and connectors");
  }
  if (!flat.wires.angles.projected)
  {
    all.emplace_back("no angles that turn by whole turns were found near those of the surface; the "
                     "wires were solved from the angles of the surface as they are");
  }
  if (flat.wires.repaired)
  {
    all.emplace_back("the patches could not all be closed one after the other; the wires have the "
                     "nearest angles that close");
  }
  if (const std::string energy = otherEnergy(context, flat); !energy.empty())
  {
    all.push_back(energy);
  }
  if (flat.placed.fromConvexStart)
  {
    all.emplace_back(context.deep()
        ? "the isometric scheme started from a convex map: a plane has no room for the piece"
        : "the isometric scheme started from a convex map: the wires' own angles led to a worse "
          "piece");
  }
  if (flat.placed.grain && flat.placed.grain->missing)
  {
    all.emplace_back("none of the curves that are to give the grain is one of the piece; its warp "
                     "lies by its upright");
  }
  if (flat.placed.grain && flat.placed.grain->bend > straightGrain)
  {
    all.emplace_back(quotedNames(context.curves, { flat.placed.grain->curve }) +
      ", which gives the grain, bends by " + shortNumber(100.0 * flat.placed.grain->bend) +
      " % of its length; the grain follows the line between its ends");
  }
  // A tube that is only mapped keeps no length.
  const bool mapped = options.scheme == Scheme::Isometric && !flat.placed.isometric;
  const double error = largestLengthError(context, flat);
  if (!mapped && !(error <= options.lengthTolerance))
  {
    all.emplace_back("the last correction of the wires' lengths ended with an edge off by " +
      shortNumber(error) + " of its length; the piece lies as it left it");
  }
  return all;
}
}

WireMeasures measureWires(const AngleProblem& problem, const Points2& positions)
{
  const WireNetwork& network = *problem.network;
  const std::vector<double> theta = planarAngles(problem, positions);
  std::vector<double> length = problem.length;
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    if (problem.stretchGroup[e] != none)
    {
      const WireEdge& edge = network.edges[e];
      length[e] = (positions[edge.to] - positions[edge.from]).norm();
    }
  }
  return { angleObjective(problem, theta), closureResidual(network, theta, length) };
}

PieceReport reportPiece(const PieceContext& context, const FlatWires& flat)
{
  const Piece& piece = context.piece;
  const WireNetwork& network = context.network;
  PieceReport report;
  report.triangles = piece.mesh.triangleCount();
  report.vertices = piece.mesh.vertexCount();
  report.wirePatches = network.patchCount;
  report.wireNodes = network.nodeCount();
  report.freeWireNodes = network.nodeCount();
  report.boundaryLoops = network.boundaryLoops;
  report.wired = std::any_of(piece.curveOfHalfedge.begin(), piece.curveOfHalfedge.end(),
    [](Index curve) { return curve != none; });
  if (context.area)
  {
    report.area = *context.area;
    const auto onCutSurface = [&piece](Indices& vertices) {
      for (Index& v : vertices)
      {
        v = piece.vertices[v];
      }
    };
    onCutSurface(report.area.cut);
    std::for_each(report.area.openings.begin(), report.area.openings.end(), onCutSurface);
  }
  report.status = flat.status;
  if (flat.status.refused())
  {
    return report;
  }
  if (flat.placed.grain)
  {
    report.cloth.emplace();
    report.cloth->oneWay = context.options.cloth->material.oneWay;
    report.cloth->shearLimit = context.options.cloth->material.shearLimit;
    report.cloth->grain = *flat.placed.grain;
    report.cloth->solved = flat.placed.clothSolved;
  }
  const WireMeasures measures = measureWires(flat.wires.problem, flat.placed.positions);
  report.objective = measures.objective;
  report.closureResidual = measures.closure;
  if (context.options.scheme == Scheme::LeastSquaresConformal)
  {
    return report;
  }
  const AngleConstraints constraints(flat.wires.problem);
  report.freeWireNodes = constraints.freeCount();
  report.constraints = constraints.rowCount();
  report.warpingOrder = flat.wires.warpingOrder;
  report.released = flat.wires.rules.released;
  report.solverUsed = flat.wires.angles.method;
  report.repaired = flat.wires.repaired;
  report.iterations = flat.wires.angles.iterations;
  report.history = flat.wires.angles.history;
  if (flat.placed.isometric)
  {
    const IsometricSolution& isometric = *flat.placed.isometric;
    report.energyUsed = flat.placed.energyUsed;
    report.otherEnergy = otherEnergy(context, flat);
    report.iterations = isometric.iterations;
    report.isometricHistory = isometric.history;
    report.distortionEnergy = isometric.distortionEnergy;
    report.angleEnergy = isometric.angleEnergy;
  }
  report.fallbacks = fallbacks(context, flat);
  return report;
}
}
