// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/NewtonKkt.h"

namespace flattening
{
struct PenaltyDescentOptions
{
  /// The largest |c_i| with which the descent ends.
  double constraintTolerance = 1e-3;
  /// The largest |c_i| with which the model switches to its final objective.
  double finalObjectiveConstraint = 0.05;
  int maxSteps = 400;
  /// No other step is begun after this many factorizations.
  int maximumFactorizations = std::numeric_limits<int>::max();
};

/// Goes down f(x) + mu / 2 |c(x)|^2 with more and more weight mu on the constraints: a way to a
/// point that nearly meets them, from one that may miss them by far, on which f stays finite and
/// what is pressed has time to give way.
/// \return the point and mu c for the multipliers; Converged where the tolerance is met.
NewtonKktState descend(NewtonKktModel& model, const Eigen::VectorXd& start, LinearSolver solver,
  const PenaltyDescentOptions& options, const Execution& execution);
}
