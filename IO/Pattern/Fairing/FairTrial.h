// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairNetwork.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace flattening::pattern
{
/// Weights of points for the next curve of least squares, which become those of the curve whose
/// farthest point is nearest. C. L. Lawson, Contributions to the theory of linear least maximum
/// approximation, thesis, University of California, 1961.
/// \param shares of each point, its deviation over its tolerance; some are not 0
void emphasize(const std::vector<double>& shares, std::vector<double>& weights);

/// Stretches drawn by as few cubic curves as are found.
struct SimplerStretches
{
  std::vector<FairStretch> stretches; ///< as their breaks and weights are then
  FairCurves curves;
};

/// Looks for splines of as few cubic curves as keep the tolerances, between nodes that stay where
/// they are, and takes longer waves away if this costs nothing that is seen.
/// \param parts numbers of a stretch, and of that which is to be its mirror image, if that is another
/// \param nodes of the network, where they are
/// \return none where the tolerances are not kept at all
std::optional<SimplerStretches> simplerStretches(const FairNetwork& network,
  const std::vector<std::size_t>& parts, const Points2& nodes, double wave, std::size_t leastSpans);
}
