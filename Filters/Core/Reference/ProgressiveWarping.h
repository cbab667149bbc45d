// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Angles/AngleSolution.h"
#include "Base/Execution.h"

namespace flattening
{
struct ProgressiveSolution
{
  AngleSolution angles;
  /// Loops in the order in which they were warped (Fig. 4).
  Indices warpingOrder;
  /// Where the last patches were over-determined and the wires do not meet: what a global solution
  /// has to aim at, to be near the progressive angles. Empty where they meet.
  std::vector<double> repairTargets;

  bool closes() const { return this->repairTargets.empty(); }
};

/// Algorithm 2: warps the patch with the largest shape-evidence factor (Eq. 10) first, ties by the
/// smallest patch id, each by Eq. 2 with the angles that are known by then locked (Eq. 9).
ProgressiveSolution warpProgressively(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution);
}
