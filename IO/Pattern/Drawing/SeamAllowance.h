// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Base/Types.h"

#include <algorithm>
#include <vector>

namespace flattening::pattern
{
/// A closed polygon with the cloth on its left. The allowance of edge k, from point k to the next,
/// lies on its right.
struct AllowancePolygon
{
  Points2 points;
  std::vector<double> allowance;
  std::vector<Points2> tabs = {}; ///< further cloth beside edges, as polygons
};

inline bool hasAllowance(const std::vector<AllowancePolygon>& polygons)
{
  return std::any_of(polygons.begin(), polygons.end(), [](const AllowancePolygon& polygon) {
    return !polygon.tabs.empty() ||
      std::any_of(polygon.allowance.begin(), polygon.allowance.end(),
        [](double allowance) { return allowance > 0.0; });
  });
}

/// Widens a piece of cloth by the allowances of its edges: the union of the piece, of the strip
/// along each edge, and of the mitres at the convex corners. A mitre is cut off where it would be
/// longer than `mitreLimit` times the allowance. Where all allowances are 0 the polygons come back
/// as they are.
/// \param polygons the outer loop and the holes of one piece
/// \param widened the borders of the cloth, counter-clockwise outer ones and clockwise holes, the largest
/// first; exact to a 10,000th of a millimetre
Status addAllowance(
  const std::vector<AllowancePolygon>& polygons, double mitreLimit, std::vector<Points2>& widened);
}
