// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"

#include <array>
#include <string>
#include <vector>

namespace wirewarp
{
/// The two banks of a dart or seam that are sewn together, where both pieces stay the same.
struct SewnBanks
{
  std::string curve;
  std::array<long long, 2> pieces{ 0, 0 };
  long long edges = 0;
  std::array<double, 2> lengths{ 0.0, 0.0 };
  /// Largest difference of two edges that are sewn together, as a fraction of their length.
  double difference = 0.0;
};

/// One entry a curve and pair of pieces, in the order of the curves.
std::vector<SewnBanks> sewnBanks(const Flattening& result);
}
