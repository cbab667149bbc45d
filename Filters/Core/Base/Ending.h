// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace flattening
{
/// How an iteration ended.
enum class Ending
{
  Converged,
  Exhausted, ///< it ran out of iterations, and was still getting on
  Stalled,   ///< no step gets nearer to the solution, or none has for long
  Cancelled,
};

/// Whether an iteration has got no nearer to zero in the second half of its run than in the first.
/// \param residuals of at least 40 iterations; of fewer nothing is known
inline bool standsStill(const std::vector<double>& residuals)
{
  constexpr std::size_t fewest = 40;
  constexpr double noticeable = 0.9;
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  return residuals.size() >= fewest &&
    *std::min_element(middle, residuals.end()) >=
    noticeable * *std::min_element(residuals.begin(), middle);
}
}
