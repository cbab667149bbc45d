// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/ReleaseTrials.h"

#include "Angles/AngleSolver.h"
#include "Flattening/PieceReporting.h"
#include "Quality/FlatteningQuality.h"
#include "Wires/KeyCurveLocks.h"

#include <algorithm>

namespace flattening
{
namespace
{
constexpr Index largeTrial = 3000; ///< triangles

double workOf(const PieceContext& context, const PlacedPiece& placed)
{
  return static_cast<double>(placed.factorizations) *
    static_cast<double>(context.piece.mesh.triangleCount());
}

/// The piece's flattening without another trial of releases. \param work what it took is added
ReleaseTrial measureTrial(
  const PieceContext& context, const CurveRules& rules, Index curve, double& work)
{
  ReleaseTrial trial;
  trial.curve = curve;
  PlacedWires placed;
  placed.wires = solveWires(context, rules);
  placed.status = placed.wires.angles.status;
  if (placed.status.refused())
  {
    return trial;
  }
  const bool solved = placed.status.ok();
  placed.placed = placeWires(context, placed.wires);
  const FlatWires flat = finishScheme(context, std::move(placed));
  work += workOf(context, flat.placed);
  // Angles without a solution may be start enough for a scheme that ends well.
  if (flat.status.refused() || !(solved || flat.status.ok()))
  {
    return trial;
  }
  const QualitySummary quality =
    measureFlattening(context.piece.mesh, flat.placed.positions, {}, context.execution).summary;
  trial.solved = true;
  trial.objective = measureWires(flat.wires.problem, flat.placed.positions).objective;
  trial.areaError = quality.areaError;
  trial.homogeneity = quality.globalHomogeneity;
  return trial;
}

/// A key curve without its shape.
ReleaseTrial tryWithoutShape(const PieceContext& context, CurveRules rules, Index key, double& work)
{
  rules.released.insert(std::upper_bound(rules.released.begin(), rules.released.end(), key), key);
  return measureTrial(context, rules, key, work);
}

/// Any other curve as no wire any more.
ReleaseTrial tryWithoutWire(
  const PieceContext& context, const CurveRules& rules, Index curve, double& work)
{
  Piece bare = context.piece;
  std::replace(bare.curveOfHalfedge.begin(), bare.curveOfHalfedge.end(), curve, none);
  const WireNetwork fewer = buildWireNetwork(bare, true);
  return measureTrial(
    { bare, fewer, context.cut, context.curves, context.options, context.execution }, rules, curve,
    work);
}
}

ReleaseAdvice adviseByTrials(const PieceContext& context, const FlatWires& flat)
{
  const Scheme scheme = context.options.scheme;
  if (scheme == Scheme::Progressive || scheme == Scheme::LeastSquaresConformal ||
    flat.status.refused() || flat.placed.fromGivenStart)
  {
    return {};
  }
  ReleaseAdvice advice = adviseRelease(context.network, context.curves, flat.wires.angles);
  // What is cut in the end needs no advice on releases; a large piece that has come to no good end
  // by one way takes too long by six.
  const bool slow = context.piece.mesh.triangleCount() > largeTrial &&
    (!flat.status.ok() || countFlipped(context.piece.mesh, flat.placed.positions) > 0);
  if (!context.options.tryReleases || context.deep() || slow)
  {
    return advice;
  }
  // The Laplacian interior distorts by itself, whatever the wires.
  const bool poor = context.options.interior.method == InteriorMethod::AsRigidAsPossible &&
    liesPoorly(context.piece.mesh, flat.placed.positions);
  const bool turned = !flat.wires.angles.status.ok() ||
    flat.status.code == StatusCode::IncompatibleKeys ||
    largestAngleChange(flat.wires.problem, flat.wires.angles.theta) > poorAngleChange;
  if (!poor && !turned)
  {
    return advice;
  }
  const Execution execution = context.execution.part(1.0, 1.0);
  const PieceContext inner{ context.piece, context.network, context.cut, context.curves,
    context.options, execution };
  const CurveRules& rules = flat.wires.rules;
  std::vector<ReleaseTrial> trials;
  double work = 0.0;
  // Another flattening of the piece is expected to take as much as this one.
  const double expected = workOf(context, flat.placed);
  for (Index curve : releaseCandidates(advice, context.network, context.curves,
         keyCurves(context.network, context.piece, context.cut, context.curves), rules.released,
         flat.wires.angles))
  {
    if (work + expected > context.options.trialWork)
    {
      break;
    }
    const bool shaped = context.curves[curve].type == CurveType::Key && !rules.releases(curve);
    trials.push_back(shaped ? tryWithoutShape(inner, rules, curve, work)
                            : tryWithoutWire(inner, rules, curve, work));
  }
  rankReleases(trials,
    scheme == Scheme::Isometric ? ReleaseMeasure::AreaError : ReleaseMeasure::Objective, advice);
  return advice;
}
}
