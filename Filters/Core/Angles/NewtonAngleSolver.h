// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Angles/AngleSolution.h"
#include "Angles/AngleSolverOptions.h"
#include "Angles/DirectionsForm.h"
#include "Base/Ending.h"
#include "Base/Execution.h"

namespace flattening
{
/// Where the Newton iteration starts, goes on and ends.
struct NewtonState
{
  Eigen::VectorXd x;           ///< unknowns of the directions form
  Eigen::VectorXd multipliers; ///< of its closures
  Ending ending = Ending::Exhausted;
};

/// Exact Newton method on the directions form: KKT systems by LDL^T with a small -delta I block and
/// refinement, inertia read from the signs of D and corrected by tau I, steps by an L1 merit
/// function with second-order correction (Nocedal and Wright, Numerical Optimization, chapter 18),
/// stretches kept in their bounds by an active set.
/// \param phase name in the records, which are appended to history.
NewtonState solveAnglesByNewton(const DirectionsForm& form, const AngleProblem& problem,
  NewtonState start, const AngleSolverOptions& options, const Execution& execution,
  const char* phase, std::vector<IterationRecord>& history);
}
