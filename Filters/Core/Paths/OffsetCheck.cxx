// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetCheck.h"

#include "Paths/PathDistance.h"

#include <algorithm>
#include <limits>

namespace flattening
{
namespace
{
constexpr double tooFar = 1.05; ///< of the distance; tangents of an arc's ends meet at 1.001
}

std::optional<OffsetFault> farthestFault(
  const SurfacePath& path, const std::vector<SurfacePath>& parts, double distance)
{
  OffsetFault worst;
  worst.distance = tooFar * distance;
  bool found = false;
  for (const SurfacePath& part : parts)
  {
    for (const SurfacePoint& point : part.points)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t leg = 0; leg + 1 < path.points.size() && nearest > worst.distance; ++leg)
      {
        nearest = std::min(nearest, footOnLeg(path, leg, point.position).gap);
      }
      if (nearest > worst.distance)
      {
        worst = { point.position, nearest };
        found = true;
      }
    }
  }
  return found ? std::optional(worst) : std::nullopt;
}
}
