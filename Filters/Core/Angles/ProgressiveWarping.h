// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolver.h"

namespace flattening
{
struct ProgressiveSolution
{
  AngleSolution angles;
  /// Loops in the order in which they were warped (Fig. 4).
  Indices warpingOrder;
  /// The last patches were over-determined, and a global solve with the progressive angles as
  /// targets made the wires meet again.
  bool repaired = false;
};

/// Algorithm 2: warps the patch with the largest shape-evidence factor (Eq. 10) first, ties by the
/// smallest patch id, each by Eq. 2 with the angles that are known by then locked (Eq. 9).
ProgressiveSolution warpProgressively(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution);
}
