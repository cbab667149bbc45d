// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace flattening;

namespace
{
__extension__ using Wide = __int128;

/// Exact for coordinates that are multiples of 2^-53 below 32.
int exactSign(const Point2& a, const Point2& b, const Point2& c)
{
  const auto integer = [](double x) { return static_cast<Wide>(std::ldexp(x, 53)); };
  const Wide left = (integer(a.x()) - integer(c.x())) * (integer(b.y()) - integer(c.y()));
  const Wide right = (integer(a.y()) - integer(c.y())) * (integer(b.x()) - integer(c.x()));
  return left > right ? 1 : left < right ? -1 : 0;
}
}

TEST(Orientation, IsExactWhereRoundingDecidesThePlainFormula)
{
  // Points one rounding step apart, near the line through the two others.
  const Point2 b(12.0, 12.0);
  const Point2 c(24.0, 24.0);
  int wrong = 0;
  for (int i = 0; i < 64; ++i)
  {
    for (int j = 0; j < 64; ++j)
    {
      const Point2 a(0.5 + std::ldexp(i, -53), 0.5 + std::ldexp(j, -53));
      const int exact = exactSign(a, b, c);
      const double plain = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
      wrong += (plain > 0.0) - (plain < 0.0) != exact ? 1 : 0;
      ASSERT_EQ(orientation(a, b, c), exact) << i << ' ' << j;
      ASSERT_EQ(orientation(b, c, a), exact);
      ASSERT_EQ(orientation(b, a, c), -exact);
    }
  }
  EXPECT_GT(wrong, 0) << "the case is too easy to tell anything";
}

TEST(Orientation, IsExactOnRandomNearlyCollinearPoints)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(1, std::int64_t(1) << 53);
  std::uniform_int_distribution<int> nudge(-2, 2);
  const auto real = [](std::int64_t k) { return std::ldexp(static_cast<double>(k), -53); };
  for (int k = 0; k < 20000; ++k)
  {
    const Point2 a(real(coordinate(random)), real(coordinate(random)));
    const Point2 b(real(coordinate(random)), real(coordinate(random)));
    const double t = real(coordinate(random));
    // back onto the grid of multiples of 2^-53
    const Point2 between = a + t * (b - a);
    const Point2 c(std::ldexp(std::round(std::ldexp(between.x(), 53)) + nudge(random), -53),
      std::ldexp(std::round(std::ldexp(between.y(), 53)) + nudge(random), -53));
    ASSERT_EQ(orientation(a, b, c), exactSign(a, b, c));
  }
}

TEST(Orientation, SegmentsMeetWhenTheyCrossTouchOrLieOnEachOther)
{
  const Point2 o(0, 0);
  const Point2 e(4, 0);
  EXPECT_TRUE(segmentsMeet(o, e, Point2(1, -1), Point2(2, 1)));
  EXPECT_TRUE(segmentsMeet(o, e, Point2(1, 0), Point2(2, 1)));
  EXPECT_TRUE(segmentsMeet(o, e, Point2(4, 0), Point2(5, 1)));
  EXPECT_TRUE(segmentsMeet(o, e, Point2(3, 0), Point2(6, 0)));
  EXPECT_TRUE(segmentsMeet(o, e, Point2(1, 0), Point2(2, 0)));
  EXPECT_FALSE(segmentsMeet(o, e, Point2(5, 0), Point2(6, 0)));
  EXPECT_FALSE(segmentsMeet(o, e, Point2(1, 1), Point2(2, 0.001)));
  EXPECT_FALSE(segmentsMeet(o, e, Point2(1, 1e-300), Point2(2, 1)));
}
