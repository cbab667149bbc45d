// SPDX-License-Identifier: BSD-3-Clause
#include "Cloth/ClothMeasures.h"

#include "Cloth/ClothEnergy.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Of shareOver5Percent.
constexpr double noticeable = 0.05;
/// A strain that is beyond its limit by less is rounding of one that lies on it.
constexpr double rounding = 1e-9;

/// By how many times the width of the limits a strain is beyond them; 0 within.
double excess(double strain, const StrainLimits& limits)
{
  if (strain > limits.greatest + rounding)
  {
    return (strain - limits.greatest) / limits.greatest;
  }
  return strain < limits.least - rounding ? (limits.least - strain) / -limits.least : 0.0;
}

double excess(const ThreadStrain& strain, const ClothMaterial& material)
{
  const double lock = material.shearLimit;
  if (!isPossible(strain))
  {
    return largestThreadStrain / rounding;
  }
  return std::max({ excess(strain.warp, material.warpLimits),
    excess(strain.weft, material.weftLimits), excess(strain.shear, { -lock, lock }) });
}
}

std::vector<ThreadStrain> measureThreads(
  const std::vector<TriangleFrame>& frames, const Triangles& triangles, const Points2& positions)
{
  std::vector<ThreadStrain> strains(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (!(frames[t].area > 0.0))
    {
      continue; // without extent it has no strain
    }
    Eigen::Vector2d a = Eigen::Vector2d::Zero();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      // From the first corner, which keeps the digits of pieces far from the origin.
      const Point2 d = positions[triangles[t][k]] - positions[triangles[t][0]];
      const Eigen::Vector2d gradient(frames[t].gradient[k].real(), frames[t].gradient[k].imag());
      a += 2.0 * d.x() * gradient;
      b += 2.0 * d.y() * gradient;
    }
    strains[t] = threadStrain(a, b);
  }
  return strains;
}

ClothSummary summarizeThreads(const std::vector<TriangleFrame>& frames,
  const std::vector<ThreadStrain>& strains, const ClothMaterial& material)
{
  ClothSummary summary;
  summary.outOfLimit.assign(strains.size(), 0);
  double area = 0.0;
  double whole = 0.0;
  double worst = 0.0;
  for (std::size_t t = 0; t < strains.size(); ++t)
  {
    const ThreadStrain& strain = strains[t];
    const double weight = frames[t].area;
    const double beyond = weight > 0.0 ? excess(strain, material) : 0.0;
    area += weight;
    if (beyond > 0.0)
    {
      summary.outOfLimit[t] = 1;
      summary.shareOutOfLimit += weight;
    }
    if (beyond > worst)
    {
      worst = beyond;
      summary.worstTriangle = static_cast<Index>(t);
    }
    if (std::max(std::abs(strain.warp), std::abs(strain.weft)) > noticeable)
    {
      summary.shareOver5Percent += weight;
    }
    if (!(std::abs(strain.shear) < material.shearLimit - rounding))
    {
      summary.shareLocked += weight;
    }
    if (isPossible(strain))
    {
      whole += weight;
      summary.warpRms += weight * strain.warp * strain.warp;
      summary.weftRms += weight * strain.weft * strain.weft;
      summary.shearRms += weight * strain.shear * strain.shear;
    }
  }
  for (double* rms : { &summary.warpRms, &summary.weftRms, &summary.shearRms })
  {
    *rms = whole > 0.0 ? std::sqrt(*rms / whole) : 0.0;
  }
  for (double* share :
    { &summary.shareOutOfLimit, &summary.shareOver5Percent, &summary.shareLocked })
  {
    *share = area > 0.0 ? std::min(1.0, *share / area) : 0.0;
  }
  return summary;
}
}
