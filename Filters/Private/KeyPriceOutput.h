// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Design/KeyPrices.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// Output 3 of vtkKeyCurvePrices.
void writeKeyPrices(
  const std::vector<FeatureCurve>& curves, const KeyPrices& prices, vtkPolyData* output);
}
}
