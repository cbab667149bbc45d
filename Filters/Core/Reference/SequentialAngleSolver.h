// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Angles/AngleSolution.h"
#include "Base/Execution.h"

namespace flattening
{
/// The paper's iteration: Eq. 15 with SuperLU from theta = alpha, lambda = 0, until the closure and
/// the gradient of the Lagrangian are within the options' tolerances (Algorithm 1 stops earlier).
/// The first-order model of the constraints converges linearly where the paper's wires are few; it
/// may not converge at all on strongly curved surfaces. A single loop is solved by Eqs. 5 to 7: a
/// 3 x 3 system in each iteration, by singular value decomposition, because too many locked angles
/// make it singular.
AngleSolution solveAnglesSequentially(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution);

/// Solves Eq. 13 by the method of the options. Problems with stretch groups are solved by Newton,
/// whatever the options say (see AngleSolution::method).
AngleSolution solveAngles(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution);
}
