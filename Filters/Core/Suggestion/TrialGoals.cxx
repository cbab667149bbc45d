// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/TrialGoals.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// No triangle counts for more.
constexpr double mostStrain = 2.0;

double strainOf(const TriangleQuality& quality)
{
  if (!(quality.smallStretch > 0.0))
  {
    return mostStrain;
  }
  return std::min(mostStrain,
    std::max(std::abs(std::log(quality.smallStretch)), std::abs(std::log(quality.largeStretch))));
}
}

std::vector<double> peakStrains(const FlatteningResult& flat, const std::vector<double>& counted)
{
  std::vector<double> peaks(flat.pieces.size(), 0.0);
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    peaks[flat.cut->pieceOfTriangle[t]] += counted[t] * std::pow(strainOf(flat.triangles[t]), 4.0);
  }
  return peaks;
}

std::vector<double> areaChanges(const FlatteningResult& flat, const std::vector<double>& counted)
{
  std::vector<double> changes(flat.pieces.size(), 0.0);
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    changes[flat.cut->pieceOfTriangle[t]] +=
      counted[t] * std::abs(flat.triangles[t].areaRatio - 1.0);
  }
  return changes;
}

Point3 worstPlace(const FlatteningResult& flat, const std::vector<double>& counted)
{
  Index worst = 0;
  double most = -1.0;
  for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
  {
    const double strain = strainOf(flat.triangles[t]);
    if (strain > most && counted[t] > 0.0)
    {
      most = strain;
      worst = t;
    }
  }
  const auto& [a, b, c] = flat.cut->mesh.triangle(worst);
  return (flat.cut->mesh.point(a) + flat.cut->mesh.point(b) + flat.cut->mesh.point(c)) / 3.0;
}
}
