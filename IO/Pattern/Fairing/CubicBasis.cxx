// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/CubicBasis.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
CubicBasis::CubicBasis(const std::vector<double>& breaks)
  : Breaks(breaks)
  , Knots(2, breaks.front())
{
  for (const double at : breaks)
  {
    this->Knots.insert(this->Knots.end(), 2, at);
  }
  this->Knots.insert(this->Knots.end(), 2, breaks.back());
}

CubicBasis::Values CubicBasis::at(double t) const
{
  const auto after = std::upper_bound(this->Breaks.begin(), this->Breaks.end(), t);
  const std::size_t above = static_cast<std::size_t>(after - this->Breaks.begin());
  return this->at(std::clamp<std::size_t>(above, 1, this->Breaks.size() - 1) - 1, t);
}

CubicBasis::Values CubicBasis::at(std::size_t span, double t) const
{
  const std::size_t i = 2 * span + 3; // the knot at the start of the span
  const auto knot = [this](std::size_t k) { return this->Knots[k]; };
  // Functions of degree 0 to 3 that are not zero in the span.
  std::array<std::array<double, 4>, 4> functions{};
  functions[0][0] = 1.0;
  for (std::size_t degree = 1; degree <= 3; ++degree)
  {
    double saved = 0.0;
    for (std::size_t r = 0; r < degree; ++r)
    {
      const double right = knot(i + r + 1);
      const double left = knot(i + r + 1 - degree);
      const double part = functions[degree - 1][r] / (right - left);
      functions[degree][r] = saved + (right - t) * part;
      saved = (t - left) * part;
    }
    functions[degree][degree] = saved;
  }
  Values values;
  values.first = 2 * span;
  values.value = functions[3];
  // Function r of a degree has the knots from i - degree + r on.
  const auto width = [&](std::size_t degree, std::size_t r) {
    return knot(i + r) - knot(i + r - degree);
  };
  // Slopes of the quadratic functions.
  std::array<double, 3> slopes{};
  for (std::size_t r = 0; r < 3; ++r)
  {
    const double rise = r > 0 ? functions[1][r - 1] / width(2, r) : 0.0;
    const double fall = r < 2 ? functions[1][r] / width(2, r + 1) : 0.0;
    slopes[r] = 2.0 * (rise - fall);
  }
  for (std::size_t r = 0; r < 4; ++r)
  {
    const double before = r > 0 ? 1.0 / width(3, r) : 0.0;
    const double after = r < 3 ? 1.0 / width(3, r + 1) : 0.0;
    values.slope[r] = 3.0 *
      ((r > 0 ? functions[2][r - 1] * before : 0.0) - (r < 3 ? functions[2][r] * after : 0.0));
    values.bend[r] =
      3.0 * ((r > 0 ? slopes[r - 1] * before : 0.0) - (r < 3 ? slopes[r] * after : 0.0));
  }
  return values;
}
}
}
