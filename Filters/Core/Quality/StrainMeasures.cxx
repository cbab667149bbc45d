// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/StrainMeasures.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
constexpr double quantileShare = 0.95;
/// Areas of equal triangles add up to the share but for rounding.
constexpr double roundingShare = 1e-9;

struct WeightedRatio
{
  double ratio = 1.0;
  double area = 0.0;
};

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

/// The least ratio that is not exceeded on a share of the area, found by halving as a median is.
double areaQuantile(std::vector<WeightedRatio>& ratios, double area)
{
  const double wanted = quantileShare * (1.0 - roundingShare) * area;
  auto begin = ratios.begin();
  auto end = ratios.end();
  double below = 0.0;
  while (end - begin > 1)
  {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
      [](const WeightedRatio& a, const WeightedRatio& b) { return a.ratio < b.ratio; });
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
  return begin->ratio;
}
}

StrainMeasures measureStrain(
  const std::vector<TriangleFrame>& frames, const std::vector<TriangleQuality>& triangles)
{
  const double largest = std::exp(largestStrain);
  StrainMeasures measures;
  std::vector<WeightedRatio> ratios;
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
    measures.quantile = std::log(areaQuantile(ratios, area));
  }
  return measures;
}
}
