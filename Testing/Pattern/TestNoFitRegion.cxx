// SPDX-License-Identifier: BSD-3-Clause
#include "Nesting/NoFitRegion.h"

#include "Shapes.h"

using namespace shapes;

TEST(NoFitRegion, NoShapeSticksOutOfTheClothForBeingRounded)
{
  const double width = 100.0041; // of a grid of 0.01
  NoFitRegion region;
  const std::size_t shape = region.addShape(rectangle(width, 50.0), 0.0);
  const std::vector<NoFitRegion::Placed> first{ { shape, Point2(0.0, 0.0) } };
  const Point2 beside = region.lowest(first, shape, 300.0);
  ASSERT_EQ(beside.y(), 0.0);
  ASSERT_GE(beside.x(), width);
  EXPECT_EQ(region.lowest(first, shape, beside.x() + 100.01), beside);
  for (const double missing : { 1e-4, 0.003, 0.0049, 0.008 })
  {
    const double cloth = beside.x() + width - missing;
    const Point2 at = region.lowest(first, shape, cloth);
    EXPECT_LE(at.x() + width, cloth) << missing;
    EXPECT_GE(at.y(), 50.0) << missing;
  }
}

TEST(NoFitRegion, RoundShapesKeepTheirDistanceHoweverManyCornersTheyHave)
{
  for (const int corners : { 30, 400, 3000 })
  {
    NoFitRegion region;
    const Points2 polygon = regular(corners, 60.0);
    const std::size_t shape = region.addShape(polygon, 5.0);
    const Point2 at = region.lowest({ { shape, Point2(7.0, 0.0) } }, shape, 200.0);
    Points2 moved;
    for (const Point2& p : polygon)
    {
      moved.emplace_back(p + at - Point2(7.0, 0.0));
    }
    double least = 1e300;
    for (const Point2& p : moved)
    {
      least = std::min(least, distance(p, sidesOf(polygon)));
    }
    EXPECT_GE(least, 5.0 - 0.02) << corners;           // of the grid
    EXPECT_LE(least, 5.0 + 4 * 0.4 + 0.05) << corners; // of both outlines, widened and cut
  }
}
