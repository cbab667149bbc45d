// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/AngleSolver.h"

#include "Angles/DirectionsForm.h"
#include "Base/Execution.h"
#include "Sparse/NewtonKkt.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Radians that an edge may turn in one step: sine and cosine are near their tangents for no more.
constexpr double longestTurn = 1.0;

/// Exact Newton method on the directions form.
/// \param phase name in the records, which are appended to history.
NewtonKktState minimizeChange(const DirectionsForm& form, NewtonKktState start,
  const AngleSolverOptions& options, const Execution& execution, const char* phase,
  std::vector<IterationRecord>& history)
{
  const double size = perimeter(form.problem()) / form.unit();
  NewtonKktOptions newton;
  newton.maximumIterations = options.maximumIterations;
  newton.constraintTolerance = options.closureTolerance * size;
  newton.optimalityTolerance = options.optimalityTolerance;
  newton.maximumMove = longestTurn;
  newton.observe = [&](const NewtonKktRecord& iteration) {
    IterationRecord record;
    record.phase = phase;
    record.objective = iteration.objective;
    record.closure = iteration.violation / size;
    record.optimality = iteration.optimality;
    record.step = iteration.meanMove;
    history.push_back(record);
  };
  DirectionsKkt model(form);
  return minimize(model, std::move(start),
    LinearSolver(LeadingColumns{ form.rotationsAlongWires() }), newton, execution);
}

/// Steps of the homotopy from the alternative start's lengths to the true ones.
constexpr int homotopySteps = 5;

AngleSolution finish(
  const AngleProblem& problem, const DirectionsForm& form, const NewtonKktState& state)
{
  AngleSolution solution;
  solution.theta = form.angles(state.x);
  solution.sideDirection = form.directions(state.x);
  solution.length = form.lengths(state.x);
  solution.stretch = form.stretches(state.x);
  const Index loops = problem.network->loopCount();
  const double unit = form.unit();
  for (Index loop = 0; loop < loops; ++loop)
  {
    solution.multiplierX.push_back(state.multipliers[2 * loop] / unit);
    solution.multiplierY.push_back(state.multipliers[2 * loop + 1] / unit);
  }
  solution.objective = angleObjective(problem, solution.theta);
  solution.closure = closureResidual(*problem.network, solution.theta, solution.length);
  if (state.termination == Termination::Cancelled)
  {
    solution.status = { StatusCode::Cancelled, "cancelled while solving for the wires", {} };
  }
  else if (state.termination == Termination::IterationLimit)
  {
    solution.status = { StatusCode::NotConverged,
      "the wires' angles did not converge in the iterations that are allowed", {},
      { Remedy::AllowAngleIterations } };
  }
  else if (state.termination == Termination::Stalled)
  {
    solution.status = { StatusCode::NotConverged,
      "the wires' angles stopped short of a solution, and more iterations would change nothing", {},
      {} };
  }
  return solution;
}

/// Follows the minimum from the lengths of the other start to the true ones.
NewtonKktState followLengths(const AngleStart& start, const AngleProblem& problem,
  DirectionsForm& form, const AngleSolverOptions& options, const Execution& execution,
  std::vector<IterationRecord>& history)
{
  NewtonKktState state;
  state.x = form.unknowns(start.theta);
  for (int step = 0; step <= homotopySteps; ++step)
  {
    const double t = static_cast<double>(step) / homotopySteps;
    std::vector<double> length(problem.length.size());
    for (std::size_t e = 0; e < length.size(); ++e)
    {
      length[e] = (1.0 - t) * start.length[e] + t * problem.length[e];
    }
    form.setLengths(length);
    AngleSolverOptions rough = options;
    if (step < homotopySteps)
    {
      // On the way it is enough to stay near the minimum.
      rough.maximumIterations = std::min(options.maximumIterations, 20);
      rough.closureTolerance = rough.optimalityTolerance = 1e-6;
    }
    state = minimizeChange(form, std::move(state), rough, execution, "homotopy", history);
    if (state.termination == Termination::Cancelled)
    {
      break;
    }
  }
  return state;
}

bool better(const AngleSolution& a, const AngleSolution& b, const AngleProblem& problem)
{
  if (a.status.ok() != b.status.ok())
  {
    return a.status.ok();
  }
  const bool foldedA = std::isinf(largestAngleChange(problem, a.theta));
  const bool foldedB = std::isinf(largestAngleChange(problem, b.theta));
  return foldedA != foldedB ? foldedB : a.objective < b.objective;
}

/// What all ways of solving have to say at their end.
void close(
  const DirectionsForm& form, std::vector<IterationRecord> history, AngleSolution& solution)
{
  solution.iterations = static_cast<int>(std::count_if(
    history.begin(), history.end(), [](const IterationRecord& r) { return r.step > 0.0; }));
  solution.history = std::move(history);
  if (!form.contradictions().empty() && solution.status.code != StatusCode::Cancelled)
  {
    solution.status = { StatusCode::IncompatibleKeys,
      "the angles that key curves prescribe contradict each other",
      { ElementKind::WireNodes, form.contradictions() },
      { { Remedy::MakeAccessory, "key curves" } } };
  }
}
}

AngleSolution solveAnglesByNewton(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution)
{
  const DirectionsForm form(problem);
  std::vector<IterationRecord> history;
  NewtonKktState start;
  start.x = form.unknowns(form.projectedAngles());
  AngleSolution solution =
    finish(problem, form, minimizeChange(form, start, options, execution, "newton", history));
  close(form, std::move(history), solution);
  return solution;
}

bool wantsAnotherStart(const AngleProblem& problem, const AngleSolution& solution)
{
  return solution.method == AngleMethod::Newton && solution.status.code != StatusCode::Cancelled &&
    (!solution.status.ok() || largestAngleChange(problem, solution.theta) > poorAngleChange);
}

AngleSolution solveAnglesFrom(const AngleStart& start, AngleSolution plain,
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution)
{
  DirectionsForm form(problem);
  std::vector<IterationRecord> history = std::move(plain.history);
  AngleSolution solution =
    finish(problem, form, followLengths(start, problem, form, options, execution, history));
  if (solution.status.code != StatusCode::Cancelled && !better(solution, plain, problem))
  {
    solution = std::move(plain);
  }
  close(form, std::move(history), solution);
  return solution;
}

double largestAngleChange(const AngleProblem& problem, const std::vector<double>& theta)
{
  // A dart's tip where the surface is saddle-like has an angle near or above 2 pi of its own.
  constexpr double nearFull = 2.0 * pi - 0.2;
  double worst = 0.0;
  for (std::size_t i = 0; i < theta.size(); ++i)
  {
    if (problem.locks.locked[i] || problem.weight[i] == 0.0)
    {
      continue;
    }
    const bool tip = problem.target[i] > nearFull;
    if (!(theta[i] > 0.0 && (theta[i] < 2.0 * pi || tip)))
    {
      return HUGE_VAL;
    }
    worst = std::max(worst, std::abs(theta[i] - problem.target[i]));
  }
  return worst;
}

std::vector<double> lengthSensitivity(const WireNetwork& network, const AngleSolution& solution)
{
  std::vector<double> sensitivity(network.edges.size(), 0.0);
  for (Index side = 0; side < network.nodeCount(); ++side)
  {
    const Index loop = network.loop[side];
    const double phi = solution.sideDirection[side];
    sensitivity[network.edge[side]] +=
      solution.multiplierX[loop] * std::cos(phi) + solution.multiplierY[loop] * std::sin(phi);
  }
  return sensitivity;
}
}
