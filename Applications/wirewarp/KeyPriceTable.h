// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"

#include <string>
#include <vector>

namespace wirewarp
{
/// A row of vtkKeyCurvePrices.
struct KeyTrialRow
{
  std::string what;
  double price = 0.0; ///< not a number but for "without NAME"
  double areaError = 0.0;
  double strainP95 = 0.0;
  std::string status;
  std::string released;
};

/// What --price-keys found; empty without it.
std::vector<KeyTrialRow> keyTrials(const Flattening& result);

/// The same as a table; empty without --price-keys.
std::string keyPriceTable(const Flattening& result);
}
