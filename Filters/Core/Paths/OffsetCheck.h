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
/// every fault that is found is one, and some on a bent surface are not. Where an edge is as long
/// as the distance the way from one ray's end to the next may pass a vertex on its wrong side.
std::optional<OffsetFault> farthestFault(
  const SurfacePath& path, const std::vector<SurfacePath>& parts, double distance);
}
