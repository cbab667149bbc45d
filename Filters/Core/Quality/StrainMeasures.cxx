// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/StrainMeasures.h"

#include "Quality/AreaQuantile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{
/// max(S, 1 / s), whose logarithm is the strain.
double stretchRatio(const TriangleQuality& quality, double largest)
{
  const double small = quality.smallStretch;
  const double large = quality.largeStretch;
  // As a negation, so that it holds for what is no number as well.
  if (!(small > 1.0 / largest && large < largest))
  {
    return largest;
  }
  return std::max(large, 1.0 / small);
}
}

StrainMeasures measureStrain(
  const std::vector<TriangleFrame>& frames, const std::vector<TriangleQuality>& triangles)
{
  const double largest = std::exp(largestStrain);
  StrainMeasures measures;
  std::vector<AreaValue> ratios;
  ratios.reserve(triangles.size());
  double area = 0.0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const double weight = frames[t].area;
    if (!(weight > 0.0))
    {
      continue;
    }
    const TriangleQuality& quality = triangles[t];
    const double large = quality.largeStretch < largest ? quality.largeStretch : largest;
    const double small = std::clamp(quality.smallStretch, -large, large);
    area += weight;
    measures.rigidEnergy +=
      weight * ((large - 1.0) * (large - 1.0) + (small - 1.0) * (small - 1.0));
    ratios.push_back({ stretchRatio(quality, largest), weight });
  }
  if (area > 0.0)
  {
    measures.rigidEnergy /= area;
    measures.quantile = std::log(areaQuantile(std::move(ratios)));
  }
  return measures;
}
}
