// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothEnergy.h"
#include "Cloth/ClothMaterial.h"
#include "Surface/TriangleFrame.h"

#include <vector>

namespace flattening
{
/// What the threads of a flat piece have to do on the surface. Means and shares are by area on the
/// surface; triangles that are turned over or have no area do not count in means, and those that
/// are turned over count as out of limit.
struct ClothSummary
{
  double warpRms = 0.0; ///< root mean square of the strain
  double weftRms = 0.0;
  double shearRms = 0.0; ///< in radians
  double shareOutOfLimit = 0.0;
  double shareOver5Percent = 0.0; ///< of warp or weft, drawn or compressed
  double shareLocked = 0.0;       ///< sheared to the material's limit or beyond
  std::vector<char> outOfLimit;   ///< per triangle
  Index worstTriangle = none;     ///< of those out of limit, the one farthest out
};

/// \param outline planar positions of the corners, per triangle, weft along x and warp along y.
std::vector<ThreadStrain> measureThreads(
  const std::vector<TriangleFrame>& frames, const Triangles& triangles, const Points2& positions);

ClothSummary summarizeThreads(const std::vector<TriangleFrame>& frames,
  const std::vector<ThreadStrain>& strains, const ClothMaterial& material);
}
