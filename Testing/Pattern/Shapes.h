// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/PlaneGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

/// What tests without drawings share.
namespace shapes
{
using namespace flattening;
using namespace flattening::pattern;

inline Points2 rectangle(double width, double height)
{
  return { { 0.0, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } };
}

/// A regular polygon, counter-clockwise from the right.
inline Points2 regular(int corners, double radius, const Point2& center = Point2::Zero())
{
  Points2 points;
  for (int k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * pi * k / corners;
    points.emplace_back(center + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

inline Segments sidesOf(const Points2& polygon)
{
  Segments sides;
  addSegments(polygon, true, sides);
  return sides;
}
}
