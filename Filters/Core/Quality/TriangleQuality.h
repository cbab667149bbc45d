// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace flattening
{
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
}
