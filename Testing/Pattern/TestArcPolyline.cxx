// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/ArcPolyline.h"

#include "Shapes.h"

namespace
{
using namespace shapes;

constexpr double tolerance = 0.03;

/// Points of the arcs, close together.
Points2 sampled(const std::vector<ArcVertex>& vertices, bool closed)
{
  Points2 points;
  const std::size_t count = vertices.size();
  for (std::size_t k = 0; k + (closed ? 0 : 1) < count; ++k)
  {
    const Point2 from = vertices[k].at;
    const Point2 chord = vertices[(k + 1) % count].at - from;
    const double bulge = vertices[k].bulge;
    for (int step = 0; step < 200; ++step)
    {
      const double s = step / 200.0;
      if (bulge == 0.0)
      {
        points.emplace_back(from + s * chord);
        continue;
      }
      // The circle by its definition: the chord seen at half of the arc's angle.
      const double angle = 4.0 * std::atan(bulge);
      const double radius = chord.norm() / (2.0 * std::sin(std::abs(angle) / 2.0));
      const Point2 normal = Point2(-chord.y(), chord.x()).normalized();
      const Point2 center =
        from + chord / 2.0 + (bulge > 0.0 ? 1.0 : -1.0) * radius * std::cos(angle / 2.0) * normal;
      const Point2 arm = from - center;
      const double turn = s * angle;
      points.emplace_back(
        center + std::cos(turn) * arm + std::sin(turn) * Point2(-arm.y(), arm.x()));
    }
  }
  points.push_back(closed ? vertices.front().at : vertices.back().at);
  return points;
}

double distanceTo(const Points2& line, const Point2& p)
{
  Segments sides;
  addSegments(line, false, sides);
  return distance(p, sides);
}
}

TEST(ArcPolyline, AStraightLineIsTwoVerticesAndACircleAFewArcs)
{
  Points2 straight;
  const Points2 circle = regular(400, 80.0);
  for (int k = 0; k < 400; ++k)
  {
    straight.emplace_back(k * 0.5, k * 0.25);
  }
  EXPECT_EQ(arcPolyline(straight, false, tolerance).size(), 2U);
  const std::vector<ArcVertex> arcs = arcPolyline(circle, true, tolerance);
  EXPECT_LE(arcs.size(), 5U);
  for (const Point2& p : sampled(arcs, true))
  {
    EXPECT_NEAR(p.norm(), 80.0, tolerance);
  }
}

TEST(ArcPolyline, CornersAndChordsStayAsTheyAre)
{
  Points2 square;
  for (const auto& [from, way] : { std::pair(Point2(0.0, 0.0), Point2(1.0, 0.0)),
         std::pair(Point2(100.0, 0.0), Point2(0.0, 1.0)),
         std::pair(Point2(100.0, 100.0), Point2(-1.0, 0.0)),
         std::pair(Point2(0.0, 100.0), Point2(0.0, -1.0)) })
  {
    for (int k = 0; k < 50; ++k)
    {
      square.emplace_back(from + 2.0 * k * way);
    }
  }
  std::rotate(square.begin(), square.begin() + 20, square.end());
  EXPECT_EQ(arcPolyline(square, true, tolerance).size(), 4U);
  const std::vector<ArcVertex> sides = arcPolyline(regular(8, 80.0), true, tolerance);
  EXPECT_EQ(sides.size(), 8U);
  for (const ArcVertex& side : sides)
  {
    EXPECT_EQ(side.bulge, 0.0);
  }
}

TEST(ArcPolyline, ASmoothLineStaysWithinTheToleranceInBothDirections)
{
  for (const double sign : { 1.0, -1.0 })
  {
    Points2 wave;
    for (int k = 0; k <= 600; ++k)
    {
      wave.emplace_back(0.5 * k, sign * 30.0 * std::sin(0.02 * k));
    }
    const std::vector<ArcVertex> arcs = arcPolyline(wave, false, tolerance);
    EXPECT_LT(arcs.size(), 60U);
    EXPECT_EQ(arcs.front().at, wave.front());
    EXPECT_EQ(arcs.back().at, wave.back());
    const Points2 drawn = sampled(arcs, false);
    for (const Point2& p : wave)
    {
      EXPECT_LE(distanceTo(drawn, p), tolerance + 0.002);
    }
    for (const Point2& p : drawn)
    {
      EXPECT_LE(distanceTo(wave, p), tolerance + 0.002);
    }
  }
}
