// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace flattening
{
/// A measure of a part of a surface, and the area of that.
struct AreaValue
{
  double value = 0.0;
  double area = 0.0;
};

/// The least of the values that is not exceeded on 95 % of the area; 0 where there is none.
double areaQuantile(std::vector<AreaValue> values);
}
