// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/StrainMeasures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{
/// Areas of equal triangles add up to the share but for rounding.
constexpr double roundingShare = 1e-9;
}

double areaQuantile(std::vector<AreaValue> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  double area = 0.0;
  for (const AreaValue& value : values)
  {
    area += value.area;
  }
  const double wanted = quantileShare * (1.0 - roundingShare) * area;
  // By halving, as a median is found.
  auto begin = values.begin();
  auto end = values.end();
  double below = 0.0;
  while (end - begin > 1)
  {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(
      begin, middle, end, [](const AreaValue& a, const AreaValue& b) { return a.value < b.value; });
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
  return begin->value;
}

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

double measureRigidEnergy(
  const TriangleFrames& frames, const std::vector<TriangleQuality>& triangles)
{
  const double largest = std::exp(largestStrain);
  double energy = 0.0;
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
    energy += weight * ((large - 1.0) * (large - 1.0) + (small - 1.0) * (small - 1.0));
  }
  return area > 0.0 ? energy / area : 0.0;
}

StrainMeasures measureStrain(
  const TriangleFrames& frames, const std::vector<TriangleQuality>& triangles)
{
  StrainMeasures measures;
  measures.rigidEnergy = measureRigidEnergy(frames, triangles);
  const double largest = std::exp(largestStrain);
  std::vector<AreaValue> ratios;
  ratios.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (frames[t].area > 0.0)
    {
      ratios.push_back({ stretchRatio(triangles[t], largest), frames[t].area });
    }
  }
  if (!ratios.empty())
  {
    measures.quantile = std::log(areaQuantile(std::move(ratios)));
  }
  return measures;
}
}
