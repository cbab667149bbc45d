// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Design/KeyPrices.h"

class vtkTable;

namespace flattening
{
namespace bridge
{
/// Output 5 of vtkKeyCurvePrices.
void writeKeyPrices(
  const std::vector<FeatureCurve>& curves, const KeyPrices& prices, vtkTable* table);
}
}
