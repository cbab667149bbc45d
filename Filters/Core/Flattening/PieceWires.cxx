// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceWires.h"

#include "Angles/AngleSolver.h"
#include "Angles/KeyRelease.h"
#include "Angles/WireLayout.h"
#include "Embedding/LeastSquaresConformalMap.h"
#include "Embedding/Untangling.h"
#include "Quality/FlatteningQuality.h"
#include "Reference/InteriorRelaxation.h"
#include "Reference/ProgressiveWarping.h"
#include "Reference/SequentialAngleSolver.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace flattening
{
namespace
{
/// Iterations without a fold less after which a start is given up: none of 77 runs on real pieces
/// and their refinements untangled one after more.
constexpr int patienceForStart = 40;
/// The isometric scheme moves all of it anyway.
constexpr double energyToleranceOfStart = 1e-3;
/// Trials that are kept, so that the chosen one need not be solved again.
constexpr std::size_t maximumTrialsKept = 64;

AngleSolution solveFromBestStart(const PieceContext& context, const AngleProblem& problem)
{
  const AngleSolverOptions& options = context.options.angles;
  AngleSolution plain = solveAngles(problem, options, context.execution);
  if (!wantsAnotherStart(problem, plain))
  {
    return plain;
  }
  const AngleStart start = conformalStart(context.piece, context.network, context.execution);
  return solveAnglesFrom(start, std::move(plain), problem, options, context.execution);
}

/// The angles nearest to the progressive ones with which the wires meet.
AngleSolution repairAngles(
  const PieceContext& context, const AngleProblem& problem, const ProgressiveSolution& progressive)
{
  AngleProblem nearest = problem;
  nearest.target = progressive.repairTargets;
  AngleSolution solution = solveFromBestStart(context, nearest);
  if (!solution.status.ok() && solution.status.code != StatusCode::Cancelled)
  {
    // From wild angles the iteration may fail where that from the surface angles does not.
    solution = solveFromBestStart(context, problem);
  }
  solution.objective = angleObjective(problem, solution.theta);
  solution.iterations += progressive.angles.iterations;
  solution.history.insert(
    solution.history.begin(), progressive.angles.history.begin(), progressive.angles.history.end());
  return solution;
}

void warpPatches(const PieceContext& context, PieceSolution& solution)
{
  AngleProblem problem = solution.problem;
  AngleSolution elastic;
  if (!problem.groups.empty())
  {
    // Lengths that may change are chosen for the piece as a whole, then warped patch by patch.
    elastic = solveFromBestStart(context, problem);
    if (!elastic.status.ok())
    {
      solution.angles = std::move(elastic);
      return;
    }
    problem.length = elastic.length;
    problem.groups.clear();
    problem.stretchGroup.assign(problem.stretchGroup.size(), none);
  }
  ProgressiveSolution progressive =
    warpProgressively(problem, context.options.angles, context.execution);
  for (Index loop : progressive.warpingOrder)
  {
    solution.report.warpingOrder.push_back(context.network.patchOfLoop[loop]);
  }
  solution.report.repaired = !progressive.closes();
  solution.angles = solution.report.repaired ? repairAngles(context, problem, progressive)
                                             : std::move(progressive.angles);
  solution.angles.stretch = elastic.stretch;
}

bool folds(const PieceContext& context, const PieceSolution& solution)
{
  return context.options.interior.method == InteriorMethod::AsRigidAsPossible &&
    !solution.placement.refused() && countFlipped(context.piece.mesh, solution.positions) > 0;
}

CurveRules withReleased(CurveRules rules, const Indices& released)
{
  Indices all;
  std::set_union(rules.released.begin(), rules.released.end(), released.begin(), released.end(),
    std::back_inserter(all));
  rules.released = std::move(all);
  return rules;
}

/// \param flat whether a trial counts only where the piece lies without a fold; then trials are
/// placed. \return nothing where no release helps
std::optional<PieceSolution> release(
  const PieceContext& context, const CurveRules& rules, const Indices& keys, bool flat)
{
  std::map<Indices, PieceSolution> good;
  std::optional<PieceSolution> cancelled;
  const auto objective = [&](const Indices& released) -> std::optional<double> {
    if (cancelled)
    {
      return std::nullopt;
    }
    PieceSolution trial = solveWires(context, withReleased(rules, released));
    bool helps = trial.status.ok();
    if (helps && flat)
    {
      placeWires(context, trial);
      helps = !trial.placement.refused() && !folds(context, trial);
      noteStatus(trial.placement, trial.status);
    }
    if (trial.status.code == StatusCode::Cancelled)
    {
      cancelled = std::move(trial);
      return std::nullopt;
    }
    const double value = trial.angles.objective;
    if (helps)
    {
      good[released] = std::move(trial);
      if (good.size() > maximumTrialsKept)
      {
        good.erase(good.begin());
      }
    }
    return helps ? std::optional<double>(value) : std::nullopt;
  };
  const KeyRelease found = releaseKeys(keys, objective);
  if (cancelled || found.released.empty())
  {
    return cancelled;
  }
  const auto chosen = good.find(found.released);
  PieceSolution result = chosen != good.end()
    ? std::move(chosen->second)
    : solveWires(context, withReleased(rules, found.released));
  result.status = describeRelease(context.curves, keys, found);
  return result;
}
}

PieceSolution solveWires(const PieceContext& context, const CurveRules& rules)
{
  PieceSolution solution;
  solution.rules = rules;
  solution.problem =
    makeWireProblem(context.network, context.piece, context.cut, context.curves, rules);
  if (context.options.scheme == Scheme::Progressive)
  {
    warpPatches(context, solution);
  }
  else
  {
    solution.angles = solveFromBestStart(context, solution.problem);
  }
  if (solution.angles.status.ok() && solution.locks() &&
    std::isinf(largestAngleChange(solution.problem, solution.angles.theta)))
  {
    solution.angles.status = { StatusCode::IncompatibleKeys,
      "the shapes of the key curves together fold a wire's angle over", {},
      { { Remedy::MakeAccessory, "key curves" } } };
  }
  solution.status = solution.angles.status;
  return solution;
}

void placeWires(const PieceContext& context, PieceSolution& solution)
{
  if (!solution.positions.empty() || solution.status.refused())
  {
    return;
  }
  context.execution.report(0.1, "Placing the interior");
  solution.positions = layOutWires(context.network, solution.angles.theta, solution.angles.length);
  InteriorOptions interior = context.options.interior;
  if (context.options.scheme == Scheme::Isometric)
  {
    interior.energyTolerance = std::max(interior.energyTolerance, energyToleranceOfStart);
  }
  noteStatus(placeInterior(context.piece, context.network, interior, context.execution,
               solution.positions, context.interiors)
               .status,
    solution.placement);
  if (context.options.interior.method == InteriorMethod::AsRigidAsPossible &&
    !solution.placement.refused())
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
      context.piece, context.network, context.execution, solution.positions, options);
    noteStatus(untangled.status, solution.placement);
  }
}

PieceSolution solveWithKeys(const PieceContext& context, const CurveRules& rules)
{
  CurveRules asked = rules;
  const Indices keys = keyCurves(context.network, context.piece, context.cut, context.curves);
  if (context.options.releaseKeys)
  {
    asked.released = keys;
  }
  PieceSolution result = solveWires(context, asked);
  if (result.locks() && !result.status.ok() && !result.status.refused())
  {
    std::optional<PieceSolution> released = release(context, asked, keys, false);
    if (released)
    {
      result = std::move(*released);
    }
    else if (result.status.code == StatusCode::IncompatibleKeys)
    {
      result.status = describeClash(context.curves, keys);
    }
  }
  return result;
}

std::optional<PieceSolution> releaseFoldingKeys(
  const PieceContext& context, const PieceSolution& folded)
{
  if (!folded.locks() || !folds(context, folded))
  {
    return std::nullopt;
  }
  std::optional<PieceSolution> released = release(context, folded.rules,
    keyCurves(context.network, context.piece, context.cut, context.curves), true);
  if (released)
  {
    placeWires(context, *released);
  }
  return released;
}

double largestLengthError(const AngleProblem& problem, const std::vector<double>& lengths,
  const Points2& positions, bool all)
{
  const WireNetwork& network = *problem.network;
  double worst = 0.0;
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    if (lengths[e] > 0.0 && (all || problem.held[e]))
    {
      const Point2& from = positions[edge.from];
      const Point2& to = positions[edge.to];
      const double error = std::abs((to - from).norm() - lengths[e]) - roundingOfLength(from, to);
      worst = std::max(worst, error / lengths[e]);
    }
  }
  return worst;
}
}
