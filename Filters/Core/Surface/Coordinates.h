// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cmath>

namespace flattening
{
/// Coordinates beyond it, and triangles smaller than one by it, are refused: squares of areas and
/// what is summed of them would over- or underflow.
inline constexpr double largestCoordinate = 1e60;

inline bool isUsable(double x)
{
  return std::isfinite(x) && std::abs(x) <= largestCoordinate;
}

/// Raises no floating-point exception, unlike a comparison with a NaN.
inline bool isUsable(const Point3& p)
{
  return isUsable(p.x()) && isUsable(p.y()) && isUsable(p.z());
}
}
