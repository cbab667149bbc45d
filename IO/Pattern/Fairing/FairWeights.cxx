// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairWeights.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double leastFactor = 0.2;
constexpr double leastWeight = 0.01;
}

void emphasize(const std::vector<double>& shares, std::vector<double>& weights)
{
  const double most = *std::max_element(shares.begin(), shares.end());
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    weights[k] *= leastFactor + shares[k] / most;
  }
  const double mean =
    std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  for (double& weight : weights)
  {
    weight = std::max(weight / mean, leastWeight);
  }
}
}
}
