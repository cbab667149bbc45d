// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceWires.h"

#include "Angles/AngleProblem.h"
#include "Angles/AngleSolver.h"
#include "Embedding/LeastSquaresConformalMap.h"
#include "Reference/ProgressiveWarping.h"
#include "Reference/SequentialAngleSolver.h"

#include <cmath>

namespace flattening
{
namespace
{
AngleSolution solve(const PieceContext& context, const AngleProblem& problem)
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
AngleSolution repair(
  const PieceContext& context, const AngleProblem& problem, const ProgressiveSolution& progressive)
{
  AngleProblem nearest = problem;
  nearest.target = progressive.repairTargets;
  AngleSolution solution = solve(context, nearest);
  if (!solution.status.ok() && solution.status.code != StatusCode::Cancelled)
  {
    // From wild angles the iteration may fail where that from the surface angles does not.
    solution = solve(context, problem);
  }
  solution.objective = angleObjective(problem, solution.theta);
  solution.iterations += progressive.angles.iterations;
  solution.history.insert(
    solution.history.begin(), progressive.angles.history.begin(), progressive.angles.history.end());
  return solution;
}

void warpPatches(const PieceContext& context, WireSolution& wires)
{
  AngleProblem problem = wires.problem;
  AngleSolution elastic;
  if (!problem.groups.empty())
  {
    // Lengths that may change are chosen for the piece as a whole, then warped patch by patch.
    elastic = solve(context, problem);
    if (!elastic.status.ok())
    {
      wires.angles = std::move(elastic);
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
    wires.warpingOrder.push_back(context.network.patchOfLoop[loop]);
  }
  wires.repaired = !progressive.closes();
  wires.angles =
    wires.repaired ? repair(context, problem, progressive) : std::move(progressive.angles);
  wires.angles.stretch = elastic.stretch;
}
}

WireSolution solveWires(const PieceContext& context, const CurveRules& rules)
{
  WireSolution wires;
  wires.rules = rules;
  wires.problem =
    makeWireProblem(context.network, context.piece, context.cut, context.curves, rules);
  if (context.options.scheme == Scheme::Progressive)
  {
    warpPatches(context, wires);
  }
  else
  {
    wires.angles = solve(context, wires.problem);
  }
  if (wires.angles.status.ok() && wires.locks() &&
    std::isinf(largestAngleChange(wires.problem, wires.angles.theta)))
  {
    wires.angles.status = { StatusCode::IncompatibleKeys,
      "the shapes of the key curves together fold a wire's angle over", {},
      { { Remedy::MakeAccessory, "key curves" } } };
  }
  return wires;
}
}
