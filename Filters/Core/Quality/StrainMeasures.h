// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleFrame.h"

#include <vector>

namespace flattening
{
/// A measure of a part of a surface, and the area of that.
struct AreaValue
{
  double value = 0.0;
  double area = 0.0;
};

/// The share of the area that a strain is to hold on: a twentieth is left to corners and slivers.
inline constexpr double quantileShare = 0.95;

/// The least of the values that is not exceeded on that share of the area; 0 where there is none.
double areaQuantile(std::vector<AreaValue> values);

/// Measures of one flat triangle. J maps the triangle's plane in space to the plane, S >= s are its
/// singular values.
struct TriangleQuality
{
  double areaRatio = 0.0;    ///< a = A2D / A3D, signed
  double homogeneity = 0.0;  ///< min(a, 1 / a); 0 where a <= 0
  double aspectRatio = 0.0;  ///< s / S, negative where flipped
  double angleError = 0.0;   ///< mean of |angle2D - angle3D| / angle3D over its corners
  double smallStretch = 0.0; ///< s, negative where flipped
  double largeStretch = 0.0; ///< S
};

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
  const TriangleFrames& frames, const std::vector<TriangleQuality>& triangles);

StrainMeasures measureStrain(
  const TriangleFrames& frames, const std::vector<TriangleQuality>& triangles);
}
