// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Design/KeyPrices.h"
#include "Input/Columns.h"
#include "Surface/FeatureCurve.h"

#include <vector>

namespace flattening
{
/// Output 5 of vtkKeyCurvePrices.
Columns keyPriceTable(const std::vector<FeatureCurve>& curves, const KeyPrices& prices);
}
