// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace flattening
{
/// Strains of a cloth that lies in the plane, weft along x and warp along y, when it is put onto
/// the surface by the inverse of the linear map J of a triangle. With the rows a and b of J, the
/// gradients of x and y on the triangle, a weft thread of length 1 becomes |b| / det J long there
/// and a warp thread |a| / det J, at right angles less asin(a . b / (|a| |b|)).
struct ThreadStrain
{
  double warp = 0.0;  ///< |a| / det J - 1
  double weft = 0.0;  ///< |b| / det J - 1
  double shear = 0.0; ///< change of the angle between the threads, in radians
};

/// No strain counts as more than this; a triangle that is turned over or has collapsed, which no
/// cloth does, has it in both threads.
constexpr double largestThreadStrain = 100.0;

inline ThreadStrain threadStrain(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  constexpr double rightAngle = 1.57079632679489661923;
  const double det = a.x() * b.y() - a.y() * b.x();
  const double warp = a.norm();
  const double weft = b.norm();
  if (!(det > 0.0 && std::max(warp, weft) < largestThreadStrain * det))
  {
    return { largestThreadStrain, largestThreadStrain, rightAngle };
  }
  return { warp / det - 1.0, weft / det - 1.0, std::atan2(a.dot(b), det) };
}

/// Whether a cloth can have it.
inline bool isPossible(const ThreadStrain& strain)
{
  return strain.warp < largestThreadStrain;
}
}
