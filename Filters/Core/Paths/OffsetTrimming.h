// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"
#include "Paths/PathGraph.h"

#include <vector>

namespace flattening
{
/// All of an offset that is not nearer to its source than the distance: it is cut where it crosses
/// itself and what else lies at the distance, and those arcs are kept and joined that have the
/// source on one side of them only. In the order of the offset; closed where all around is kept.
/// \param shortcut the fraction of the distance by which its points are nearer to their own feet
/// \param offset all parts of it, on the left of the source
/// \param others what else lies at the distance: the offset on the other side, and the arcs round
///   both ends; walked so that the source is on their right
std::vector<SurfacePath> trimmedOffset(const PathGraph& graph, const SurfacePath& source,
  double distance, double shortcut, const std::vector<SurfacePath>& offset,
  const std::vector<SurfacePath>& others);
}
