// SPDX-License-Identifier: BSD-3-Clause
// In the place of SeamAllowance.cxx in a build without Clipper.
#include "SeamAllowance.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
PatternStatus addAllowance(
  const std::vector<AllowancePolygon>& polygons, double, std::vector<Points2>& widened)
{
  widened.clear();
  for (const AllowancePolygon& polygon : polygons)
  {
    const auto isPositive = [](double allowance) { return allowance > 0.0; };
    if (std::any_of(polygon.allowance.begin(), polygon.allowance.end(), isPositive))
    {
      return { PatternCode::InvalidOption,
        "this build cannot add a seam allowance, because it was made without Clipper; take an "
        "allowance of 0, or build with Clipper" };
    }
    widened.push_back(polygon.points);
  }
  return {};
}
}
}
