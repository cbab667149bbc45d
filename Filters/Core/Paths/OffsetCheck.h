// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"

#include <optional>

namespace flattening
{
struct OffsetFault
{
  Point3 position = Point3::Zero();
  double distance = 0.0; ///< from the path, in space
};

/// The place of an offset that lies farthest from its path, where that is more than a twentieth
/// farther than it should. Distances are those in space: none over the surface is shorter, so that
/// every fault that is found is one. What rounding in thin triangles can do at worst.
std::optional<OffsetFault> farthestFault(
  const SurfacePath& path, const std::vector<SurfacePath>& parts, double distance);
}
