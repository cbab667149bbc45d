// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace flattening
{
namespace pattern
{
/// Cubic B-splines over ascending breaks, continuously differentiable at those within, which are
/// double knots, with as many knots at both ends as make the curve end in its first and last
/// coefficient. After L. Piegl, W. Tiller, The NURBS Book, 2nd ed., Springer 1997, algorithms A2.1
/// and A2.3.
class CubicBasis
{
public:
  explicit CubicBasis(const std::vector<double>& breaks);

  std::size_t size() const { return this->Knots.size() - 4; }
  const std::vector<double>& breaks() const { return this->Breaks; }

  /// The four functions that are not zero at a place, the first of them being number `first`.
  struct Values
  {
    std::size_t first = 0;
    std::array<double, 4> value{};
    std::array<double, 4> slope{};
    std::array<double, 4> bend{}; ///< second derivative
  };
  Values at(double t) const;
  /// The same at a place of a span, its ends included.
  Values at(std::size_t span, double t) const;

private:
  std::vector<double> Breaks;
  std::vector<double> Knots;
};
}
}
