// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/AreaQuantile.h"

#include <algorithm>

namespace flattening
{
namespace
{
constexpr double quantileShare = 0.95;
/// Areas of equal triangles add up to the share but for rounding.
constexpr double roundingShare = 1e-9;
}

double areaQuantile(std::vector<AreaValue> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  double area = 0.0;
  for (const AreaValue& value : values)
  {
    area += value.area;
  }
  const double wanted = quantileShare * (1.0 - roundingShare) * area;
  // By halving, as a median is found.
  auto begin = values.begin();
  auto end = values.end();
  double below = 0.0;
  while (end - begin > 1)
  {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(
      begin, middle, end, [](const AreaValue& a, const AreaValue& b) { return a.value < b.value; });
    double lower = 0.0;
    for (auto it = begin; it != middle; ++it)
    {
      lower += it->area;
    }
    if (below + lower >= wanted)
    {
      end = middle;
    }
    else
    {
      below += lower;
      begin = middle;
    }
  }
  return begin->value;
}
}
