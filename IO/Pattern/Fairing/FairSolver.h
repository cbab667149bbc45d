// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairNetwork.h"

#include <vector>

namespace flattening::pattern
{
struct FairCurves
{
  bool converged = false; ///< every interval has its length to 1e-10 of it; else the rest is empty
  Points2 nodes;
  std::vector<std::vector<FairSpan>> spans; ///< of each stretch
  std::vector<std::vector<double>>
    deviation; ///< of the points of each stretch across it, its ends included
  std::vector<std::vector<double>> nearest; ///< along each stretch, to its points within its ends
};

/// Smooth curves of prescribed lengths near given points: least bending (the integral of the
/// squared second derivative) and least squared distance, weighed by a length of waves that are
/// smoothed away, under exact lengths, by Newton's method on the Lagrangian without the curvature
/// of the constraints.
/// \param wave the longest wave that is smoothed away, in the unit of the points
FairCurves solveFairNetwork(const FairNetwork& network, double wave);
}
