// SPDX-License-Identifier: BSD-3-Clause
#include "NoFitRegion.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
using flattening::Point2;
using flattening::Points2;
using flattening::pattern::NoFitRegion;

Points2 rectangle(double width, double height)
{
  return { Point2(0.0, 0.0), Point2(width, 0.0), Point2(width, height), Point2(0.0, height) };
}
}

TEST(NoFitRegion, NoShapeSticksOutOfTheClothForBeingRounded)
{
  if (!NoFitRegion::available())
  {
    GTEST_SKIP() << "made without Clipper";
  }
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
