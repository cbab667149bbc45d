// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace flattening
{
/// A function of one variable with two derivatives.
struct Curve2
{
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
};

/// Half the square of what x is above 0, but with a second derivative that rises to 1 over [0,
/// width] along 3 t^2 - 2 t^3 in place of a jump.
inline Curve2 smoothRamp(double x, double width)
{
  if (!(x > 0.0))
  {
    return {};
  }
  const double t = x / width;
  if (t < 1.0)
  {
    const double t3 = t * t * t;
    return { width * width * t3 * t * (0.25 - 0.1 * t), width * t3 * (1.0 - 0.5 * t),
      t * t * (3.0 - 2.0 * t) };
  }
  const double beyond = x - 0.5 * width;
  return { 0.5 * beyond * beyond + width * width / 40.0, beyond, 1.0 };
}

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

/// Stiffness of a material's stiffer thread in its energies, as |J - R|^2 has it for a stretch in
/// one direction; the other stiffnesses are in proportion.
inline constexpr double stiffestThread = 2.0;

/// Half the square of a thread's strain, times compression where it is shorter than at rest; the
/// second derivative passes from one to the other over two parts in a thousand.
Curve2 threadEnergy(double strain, double compression);
}
