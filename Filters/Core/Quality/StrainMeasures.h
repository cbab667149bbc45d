// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Quality/TriangleQuality.h"
#include "Surface/TriangleFrame.h"

#include <vector>

namespace flattening
{
/// No triangle counts as more strained than this, and none as stretched by more than exp of it. A
/// triangle that is turned over or has collapsed counts as strained by this: on the way there from
/// its shape on the surface every bound is passed.
constexpr double largestStrain = 100.0;

/// What a cutter feels where means look harmless. Both weigh triangles by their area on the
/// surface, so that those without any do not count, and are finite for every map.
struct StrainMeasures
{
  /// The strain, max |ln sigma| over both singular values, that is not exceeded on 95 % of the
  /// area.
  double quantile = 0.0;
  /// Mean of |J - R|^2 = (S - 1)^2 + (s - 1)^2, R the rotation nearest to J; s is negative where
  /// the triangle is turned over, as the nearest rotation does not turn it back.
  double rigidEnergy = 0.0;
};

/// rigidEnergy alone.
double measureRigidEnergy(
  const std::vector<TriangleFrame>& frames, const std::vector<TriangleQuality>& triangles);

StrainMeasures measureStrain(
  const std::vector<TriangleFrame>& frames, const std::vector<TriangleQuality>& triangles);
}
