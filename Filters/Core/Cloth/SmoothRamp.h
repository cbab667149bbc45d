// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
}
