// SPDX-License-Identifier: BSD-3-Clause
// The cut line against areas known by geometry and against Clipper's own offset.
#include "Drawing/SeamAllowance.h"

#include "Outlines/Outline.h"
#include "Shapes.h"

#include <clipper.hpp>

namespace
{
using namespace shapes;

AllowancePolygon uniform(const Points2& points, double allowance)
{
  return { points, std::vector<double>(points.size(), allowance) };
}

/// A star-shaped polygon with convex and concave corners.
Points2 randomPolygon(unsigned seed, std::size_t corners)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(120.0, 250.0);
  Points2 points;
  for (std::size_t k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * pi * static_cast<double>(k) / static_cast<double>(corners);
    points.emplace_back(radius(random) * Point2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

double totalArea(const std::vector<Points2>& polygons)
{
  double area = 0.0;
  for (const Points2& polygon : polygons)
  {
    area += doubleArea(polygon) / 2.0;
  }
  return area;
}

double areaOfClippersOffset(const Points2& polygon, double allowance, double mitreLimit)
{
  constexpr double scale = 1e4;
  ClipperLib::Path path;
  for (const Point2& p : polygon)
  {
    path.emplace_back(std::llround(scale * p.x()), std::llround(scale * p.y()));
  }
  ClipperLib::ClipperOffset offset(mitreLimit);
  offset.AddPath(path, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  ClipperLib::Paths result;
  offset.Execute(result, scale * allowance);
  double area = 0.0;
  for (const ClipperLib::Path& border : result)
  {
    area += ClipperLib::Area(border);
  }
  return area / (scale * scale);
}

std::vector<Points2> widen(const std::vector<AllowancePolygon>& polygons, double mitreLimit = 2.0)
{
  std::vector<Points2> widened;
  const Status status = addAllowance(polygons, mitreLimit, widened);
  EXPECT_TRUE(status.ok()) << status.message;
  return widened;
}
}

TEST(SeamAllowance, WithoutAllowanceTheCutLineIsTheSewLineToTheLastBit)
{
  const Points2 polygon = randomPolygon(1, 17);
  const std::vector<Points2> widened = widen({ uniform(polygon, 0.0) });
  ASSERT_EQ(widened.size(), 1U);
  EXPECT_EQ(widened.front(), polygon);
}

TEST(SeamAllowance, EachEdgeHasItsOwnAllowance)
{
  const AllowancePolygon polygon{ rectangle(200.0, 100.0), { 40.0, 10.0, 0.0, 15.0 } };
  const std::vector<Points2> widened = widen({ polygon }, 6.0);
  ASSERT_EQ(widened.size(), 1U);
  Box box;
  for (const Point2& p : widened.front())
  {
    box.extend(p);
  }
  EXPECT_NEAR(box.min().x(), -15.0, 1e-3);
  EXPECT_NEAR(box.min().y(), -40.0, 1e-3);
  EXPECT_NEAR(box.max().x(), 210.0, 1e-3);
  EXPECT_NEAR(box.max().y(), 100.0, 1e-3);
  EXPECT_NEAR(totalArea(widened), 225.0 * 140.0, 1e-1);
}

TEST(SeamAllowance, EqualsClippersOffsetWhereTheAllowanceIsUniform)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const Points2 polygon = randomPolygon(seed, 12 + seed);
    for (const double mitreLimit : { 2.0, 4.0 })
    {
      const double expected = areaOfClippersOffset(polygon, 10.0, mitreLimit);
      EXPECT_NEAR(
        totalArea(widen({ uniform(polygon, 10.0) }, mitreLimit)), expected, 1e-5 * expected)
        << "seed " << seed << ", limit " << mitreLimit;
    }
  }
}

TEST(SeamAllowance, NoPointOfTheCutLineIsFartherThanTheMitreLimitAllows)
{
  const double limit = 1.5;
  const Points2 spike{ { 0.0, 0.0 }, { 100.0, -3.0 }, { 100.0, 3.0 } };
  const Segments sides = sidesOf(spike);
  for (const Points2& border : widen({ uniform(spike, 10.0) }, limit))
  {
    for (const Point2& p : border)
    {
      EXPECT_LE(distance(p, sides), limit * 10.0 + 1e-3);
      EXPECT_GE(distance(p, sides), 10.0 - 1e-3);
    }
  }
}

TEST(SeamAllowance, AHoleBecomesSmallerAndASmallOneCloses)
{
  Points2 hole = rectangle(60.0, 60.0);
  for (Point2& p : hole)
  {
    p += Point2(70.0, 70.0);
  }
  std::reverse(hole.begin(), hole.end());
  const AllowancePolygon outer = uniform(rectangle(200.0, 200.0), 10.0);
  const std::vector<Points2> widened = widen({ outer, uniform(hole, 10.0) });
  ASSERT_EQ(widened.size(), 2U);
  EXPECT_NEAR(doubleArea(widened[1]) / 2.0, -40.0 * 40.0, 1e-2);
  EXPECT_EQ(widen({ outer, uniform(hole, 35.0) }).size(), 1U);
}

TEST(SeamAllowance, ARectangleKeepsItsCornersThoughPointsAreRepeatedAndTheScaleIsHuge)
{
  Points2 polygon = rectangle(200.0, 100.0);
  for (const bool repeated : { false, true })
  {
    const std::vector<Points2> widened = widen({ uniform(polygon, 10.0) });
    EXPECT_NEAR(totalArea(widened), 220.0 * 120.0, 1e-2);
    EXPECT_TRUE(repeated || (widened.size() == 1 && widened.front().size() == 4));
    polygon.insert(polygon.begin() + 2, polygon[1]);
  }
  const double huge = 1e8;
  EXPECT_NEAR(
    totalArea(widen({ uniform(rectangle(huge, huge), 10.0) })) / (huge * huge), 1.0, 1e-6);
}

TEST(SeamAllowance, APieceBelowTheGridIsToldAsTooSmall)
{
  std::vector<Points2> widened;
  const Status status = addAllowance({ uniform(rectangle(1e-6, 1e-6), 1e-6) }, 2.0, widened);
  EXPECT_EQ(status.code, StatusCode::NothingToDraw);
  ASSERT_EQ(status.remedies.size(), 1U);
  EXPECT_EQ(status.remedies.front().remedy, Remedy::CheckUnit);
}
