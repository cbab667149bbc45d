// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace wirewarp
{
/// Whether VTK's locators can be asked about a point, or about cells with it: they take fourth
/// powers of coordinates, and VTK 9.6 ends the program where one of those is no number.
inline bool canBeLocated(const std::array<double, 3>& point)
{
  constexpr double largest = 1e70;
  return std::all_of(
    point.begin(), point.end(), [](double x) { return std::isfinite(x) && std::abs(x) < largest; });
}
}
