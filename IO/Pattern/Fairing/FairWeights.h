// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace flattening
{
namespace pattern
{
/// Weights of points for the next curve of least squares, which become those of the curve whose
/// farthest point is nearest. C. L. Lawson, Contributions to the theory of linear least maximum
/// approximation, thesis, University of California, 1961.
/// \param shares of each point, its deviation over its tolerance; some are not 0
void emphasize(const std::vector<double>& shares, std::vector<double>& weights);
}
}
