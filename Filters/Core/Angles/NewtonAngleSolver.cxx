// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/NewtonAngleSolver.h"

#include "Angles/DirectionsKkt.h"

namespace flattening
{
namespace
{
/// Radians that an edge may turn in one step: sine and cosine are near their tangents for no more.
constexpr double longestTurn = 1.0;
}

NewtonKktState solveAnglesByNewton(const DirectionsForm& form, NewtonKktState start,
  const AngleSolverOptions& options, const Execution& execution, const char* phase,
  std::vector<IterationRecord>& history)
{
  const double size = perimeter(form.problem()) / form.unit();
  NewtonKktOptions newton;
  newton.maximumIterations = options.maximumIterations;
  newton.constraintTolerance = options.closureTolerance * size;
  newton.optimalityTolerance = options.optimalityTolerance;
  newton.longestMove = longestTurn;
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
}
