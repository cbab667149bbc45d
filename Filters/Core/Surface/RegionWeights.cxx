// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/RegionWeights.h"

#include "Surface/SurfaceLocator.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
Status checkWeights(const RegionWeights& weights, Index triangles)
{
  const auto refusal = [](const std::string& message, const Indices& ids = {}) {
    return Status{ StatusCode::InvalidOption, message, { ElementKind::Cells, ids },
      { { Remedy::Give, "a number from 0 for each cell, and one above 0" } } };
  };
  if (weights.empty())
  {
    return {};
  }
  if (weights.size() != static_cast<std::size_t>(triangles))
  {
    return refusal("there are " + std::to_string(weights.size()) + " weights for " +
      std::to_string(triangles) + " triangles");
  }
  Indices wrong;
  for (Index t = 0; t < triangles; ++t)
  {
    if (!std::isfinite(weights[t]) || weights[t] < 0.0)
    {
      wrong.push_back(t);
    }
  }
  if (!wrong.empty())
  {
    return refusal(
      "the weights of triangles " + listIds(wrong) + " are negative or not finite", wrong);
  }
  if (std::none_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; }))
  {
    return refusal("the weights of all triangles are 0");
  }
  return {};
}

RegionWeights relativeWeights(const TriangleMesh& mesh, const RegionWeights& weights)
{
  if (weights.empty())
  {
    return {};
  }
  const auto [least, largest] = std::minmax_element(weights.begin(), weights.end());
  if (*least == *largest)
  {
    return {};
  }
  // Relative to the largest first, so that no sum is beyond the range of numbers.
  RegionWeights relative;
  double sum = 0.0;
  double area = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    relative.push_back(weights[t] / *largest);
    sum += mesh.area(t) * relative.back();
    area += mesh.area(t);
  }
  for (double& weight : relative)
  {
    weight *= area / sum;
  }
  return relative;
}

std::vector<double> vertexWeights(const TriangleMesh& mesh, const RegionWeights& weights)
{
  if (weights.empty())
  {
    return {};
  }
  std::vector<double> sums(mesh.vertexCount(), 0.0);
  std::vector<double> areas(mesh.vertexCount(), 0.0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    for (Index v : mesh.triangle(t))
    {
      sums[v] += mesh.area(t) * weights[t];
      areas[v] += mesh.area(t);
    }
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    sums[v] = areas[v] > 0.0 ? sums[v] / areas[v] : 0.0;
  }
  return sums;
}

RegionWeights resampledWeights(
  const TriangleMesh& mesh, const RegionWeights& weights, const TriangleMesh& other)
{
  if (weights.empty())
  {
    return {};
  }
  RegionWeights resampled(other.triangleCount(), 0.0);
  std::vector<double> areas(other.triangleCount(), 0.0);
  const SurfaceLocator target(other);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Index nearest = target.closest(mesh.centroid(t)).triangle;
    resampled[nearest] += mesh.area(t) * weights[t];
    areas[nearest] += mesh.area(t);
  }
  const SurfaceLocator source(mesh);
  for (Index t = 0; t < other.triangleCount(); ++t)
  {
    resampled[t] = areas[t] > 0.0 ? resampled[t] / areas[t]
                                  : weights[source.closest(other.centroid(t)).triangle];
  }
  return resampled;
}
}
