// SPDX-License-Identifier: BSD-3-Clause
// Smooth borders of known shapes, measured by rules of their own.
#include "FairShapes.h"
#include "Shapes.h"

namespace
{
using namespace fairshapes;

PatternSource disc(int corners, double radius)
{
  return polygon(shapes::regular(corners, radius));
}

/// Length of the first edges of a polygon.
double edgesOf(const Points2& corners, std::size_t count)
{
  double length = 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    length += (corners[(k + 1) % corners.size()] - corners[k]).norm();
  }
  return length;
}

}

TEST(FairBorders, ARoundPolygonBecomesARingOfItsLengthWithFewCurves)
{
  const double radius = 50.0;
  const Smoothed smoothed(disc(48, radius), 0.2);
  const auto curve = smoothed.curve(0);
  const double length = 48 * 2.0 * radius * std::sin(pi / 48);
  EXPECT_NEAR(lengthOf(curve), length, 1e-9);
  EXPECT_LE(curve.size(), 6U);
  for (const FairSpan& span : curve)
  {
    for (int k = 0; k <= 10; ++k)
    {
      const double at = span.from + (span.to - span.from) * k / 10.0;
      EXPECT_NEAR(span.at(at).norm(), radius, 0.2);
    }
  }
  // The ring has no corner where it closes.
  const Point2 in = curve.back().control[3] - curve.back().control[2];
  const Point2 out = curve.front().control[1] - curve.front().control[0];
  EXPECT_NEAR(in.normalized().dot(out.normalized()), 1.0, 1e-9);
}

TEST(FairBorders, SidesThatAreNearlyStraightBecomeStraightAndKeepTheirLengths)
{
  Points2 corners;
  for (int side = 0; side < 4; ++side)
  {
    const double angle = pi / 2.0 * side;
    const Point2 along(std::cos(angle), std::sin(angle));
    const Point2 inward(-along.y(), along.x());
    for (int k = 0; k < 10; ++k)
    {
      const double off = k == 0 ? 0.0 : 0.05 * std::sin(2.0 * k + side);
      corners.emplace_back((20.0 * k - 100.0) * along + (off - 100.0) * inward);
    }
  }
  const Smoothed smoothed(polygon(corners), 0.2);
  const FairPieceReport& report = smoothed.report();
  EXPECT_EQ(report.straightened, 4U);
  EXPECT_EQ(report.segments, 4U);
  EXPECT_EQ(report.splines, 0U);
  const auto curve = smoothed.curve(0);
  EXPECT_NEAR(lengthOf(curve), edgesOf(corners, corners.size()), 1e-9);
  EXPECT_TRUE(
    std::all_of(curve.begin(), curve.end(), [](const FairSpan& span) { return span.straight(); }));
}

TEST(FairBorders, WhatCannotKeepToTheToleranceStaysAndIsNamed)
{
  // The chords of twelve edges are 1.7 mm inside the circle: a ring as long as they cuts their
  // corners.
  const Smoothed smoothed(disc(12, 50.0), 0.01);
  const FairPieceReport& report = smoothed.report();
  EXPECT_EQ(report.left, std::vector<std::string>{ "boundary" });
  EXPECT_GT(report.worstLeft, 0.1);
  EXPECT_EQ(report.segments, 12U);
  for (std::size_t v = 0; v < smoothed.source.positions.size(); ++v)
  {
    EXPECT_LT((smoothed.borders->positions()[v] - smoothed.source.positions[v]).norm(), 1e-9);
  }
}

TEST(FairBorders, OneCurveIsSmoothAndTheRestOfTheBorderStays)
{
  PatternSource source = disc(48, 50.0);
  SourceWire arc{ {}, WireType::Accessory, 0, 0, "arc" };
  SourceWire rest{ {}, WireType::Boundary, none, 0, "boundary" };
  for (Index k = 0; k <= 24; ++k)
  {
    arc.points.push_back(k + 1);
    rest.points.push_back((k + 24) % 48 + 1);
  }
  source.wires = { arc, rest };
  PatternOptions options;
  options.fairToleranceOfCurve = { { "arc", 0.2 } };
  const Smoothed smoothed(source, 0.0, 0.0, options);
  const double side = 2.0 * 50.0 * std::sin(pi / 48);
  const auto smooth = smoothed.curve(0);
  EXPECT_LE(smooth.size(), 4U);
  EXPECT_NEAR(lengthOf(smooth), 24 * side, 1e-9);
  const auto left = smoothed.curve(1);
  EXPECT_EQ(left.size(), 24U);
  for (const FairSpan& span : left)
  {
    EXPECT_TRUE(span.straight());
    EXPECT_NEAR(lengthOf(span), side, 1e-9);
  }
  for (const Index v : arc.points)
  {
    EXPECT_LE(distanceFrom(smooth, source.positions[static_cast<std::size_t>(v)]), 0.2 + 1e-5);
  }
}

TEST(FairBorders, ACurveWithinMeetsTheBorderAtItsLength)
{
  Points2 corners;
  for (int k = 0; k < 60; ++k)
  {
    const double angle = 2.0 * pi * k / 60;
    const double radius = 100.0 + 12.0 * std::sin(3.0 * angle) + 5.0 * std::cos(5.0 * angle);
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  PatternSource source = polygon(corners);
  for (const Index start : { 7, 19, 28 })
  {
    source.wires.push_back(
      { { start, 0, start + 30 }, WireType::Accessory, start, 0, std::to_string(start) });
  }
  const Smoothed smoothed(source, 0.5);
  for (std::size_t wire = 1; wire < source.wires.size(); ++wire)
  {
    const auto curve = smoothed.curve(wire);
    const Index start = source.wires[wire].points.front();
    const Index end = source.wires[wire].points.back();
    const Point2 first = smoothed.borders->alongEdge(start, start + 1).front().control[0];
    const Point2 last = smoothed.borders->alongEdge(end, end + 1).front().control[0];
    EXPECT_NEAR((curve.front().control[0] - first).norm(), 0.0, 1e-6);
    EXPECT_NEAR((curve.back().control[3] - last).norm(), 0.0, 1e-6);
  }
}

TEST(FairBorders, ALongWavyCurveIsDrawnWithFewSplinesAndItsExactLength)
{
  // Three waves of a sine on the lower side, in 90 edges; a cubic a quarter of a wave draws a sine
  // to 0.1 % of its height.
  Points2 corners;
  for (int k = 0; k <= 90; ++k)
  {
    corners.emplace_back(10.0 * k, 20.0 * std::sin(2.0 * pi * k / 30.0));
  }
  corners.emplace_back(900.0, 600.0);
  corners.emplace_back(0.0, 600.0);
  PatternSource source = polygon(corners);
  source.positions[0] = Point2(450.0, 300.0);
  const Smoothed smoothed(source, 1.0);
  const FairPieceReport& report = smoothed.report();
  EXPECT_TRUE(report.left.empty());
  EXPECT_EQ(report.segments, 3U);
  EXPECT_GE(
    report.splines, 2U); // a cubic turns the other way twice at most, three waves five times
  EXPECT_LE(report.splines, 4U);
  EXPECT_LE(report.deviation, 1.0);
  SourceWire wave = smoothed.source.wires[0];
  wave.points.resize(91);
  EXPECT_NEAR(lengthOf(smoothed.borders->curveOf(wave)), edgesOf(corners, 90), 1e-8);
}

TEST(FairBorders, ACornerThatCannotBeRoundedLeavesTheRestOfItsSideSmooth)
{
  // Two arcs of a circle of 200 mm, of 20 edges each, that meet by 25 degrees in edges of 12 mm: a
  // curve through there would be a third of a millimetre off.
  Points2 corners{ { 0.0, 0.0 } };
  double angle = 0.0;
  for (int k = 0; k < 40; ++k)
  {
    corners.push_back(corners.back() + 12.0 * Point2(std::cos(angle), std::sin(angle)));
    angle += k == 19 ? 25.0 * pi / 180.0 : 0.06;
  }
  const Smoothed smoothed(polygon(corners), 0.1);
  const FairPieceReport& report = smoothed.report();
  EXPECT_EQ(report.left, std::vector<std::string>{ "boundary" });
  EXPECT_GT(report.worstLeft, 0.3);
  EXPECT_EQ(report.segments, 1U); // from end to end
  EXPECT_GE(report.splines, 2U);
  EXPECT_LE(report.splines, 6U);
  EXPECT_LE(report.deviation, 0.1);
  const auto curve = smoothed.borders->alongEdge(1, 2);
  EXPECT_NEAR(lengthOf(curve), 12.0, 1e-6); // each edge keeps its length
  EXPECT_LE(distanceFrom(smoothed.borders->alongEdge(20, 21), corners[20]), 0.1);
}

TEST(FairBorders, ACornerBesideASharperOneIsACorner)
{
  // A parallelogram that turns by 50 and by 130 degrees.
  const double angle = 50.0 * pi / 180.0;
  const Point2 slant(80.0 * std::cos(angle), 80.0 * std::sin(angle));
  const Smoothed smoothed(polygon({ -slant - Point2(100.0, 0.0), Point2(100.0, 0.0) - slant,
                            slant + Point2(100.0, 0.0), slant - Point2(100.0, 0.0) }),
    1.0);
  const FairPieceReport& report = smoothed.report();
  EXPECT_EQ(report.segments, 4U);
  EXPECT_EQ(report.splines, 0U);
}

TEST(FairBorders, APieceIsDrawnNearerToItsPointsWhereItWouldBeStrained)
{
  // A ring as long as a polygon of ten corners lies within it by a sixtieth of its radius.
  PatternSource source = disc(10, 50.0);
  EXPECT_GT(Smoothed(source, 2.0).report().deviation, 0.5);
  for (const Point2& p : source.positions)
  {
    source.inSpace.emplace_back(p.x(), p.y(), 0.0);
  }
  const Smoothed smoothed(source, 2.0);
  const FairPieceReport& report = smoothed.report();
  EXPECT_LT(report.share, 1.0);
  EXPECT_LE(report.strain, 0.003);
  for (std::size_t v = 1; v < source.positions.size(); ++v)
  {
    EXPECT_NEAR(smoothed.borders->positions()[v].norm(), 50.0, 0.003 * 50.0 + 1e-3);
  }
  EXPECT_NEAR(lengthOf(smoothed.borders->curveOf(source.wires[0])),
    10 * 2.0 * 50.0 * std::sin(pi / 10), 1e-9);
}

TEST(FairBorders, AnEdgeOfAnyPartOfTheBorderIsDrawnWithAllLengths)
{
  // A rectangle with a chamfer between two corners.
  for (const double size : { 1e-3, 1.0, 100.0, 1e5 })
  {
    for (const double part : { 1e-3, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12, 0.0 })
    {
      SCOPED_TRACE(std::to_string(size) + " mm, part " + std::to_string(part));
      const double cut = part * size;
      const Points2 corners{ { -size, -size }, { size, -size }, { size, size - cut },
        { size - cut, size }, { -size, size } };
      for (const double notches : { 0.0, size / 3.0 })
      {
        const double tolerance = 0.002 * size;
        const Smoothed smoothed(polygon(corners), tolerance, notches);
        const auto border = smoothed.curve(0);
        EXPECT_NEAR(lengthOf(border), (8.0 - (2.0 - std::sqrt(2.0)) * part) * size, 1e-8 * size);
        for (const Point2& corner : corners)
        {
          EXPECT_LE(distanceFrom(border, corner), tolerance + 1e-8 * size);
        }
      }
    }
  }
}

TEST(FairBorders, BordersThatHaveCollapsedAreDrawnAsTheyAre)
{
  // A ring whose inner border, or a part of one of its borders, lies in one point or on a segment.
  constexpr Index count = 24;
  for (const double size : { 1e-2, 50.0, 1e4 })
  {
    for (const Index collapsed : { 2, 7, 24 })
    {
      for (const bool inner : { true, false })
      {
        for (const double width : { 0.0, 1e-6 })
        {
          SCOPED_TRACE(std::to_string(size) + " mm, " + std::to_string(collapsed) +
            (inner ? " inner" : " outer") + " points, " + std::to_string(width));
          PatternSource source;
          for (const double radius : { 2.0, 1.0 })
          {
            for (Index k = 0; k < count; ++k)
            {
              const double angle = 2.0 * pi * k / count;
              source.positions.emplace_back(
                size * radius * Point2(std::cos(angle), std::sin(angle)));
            }
          }
          for (Index k = 0; k < count; ++k)
          {
            const Index next = (k + 1) % count;
            source.triangles.push_back({ k, next, count + k });
            source.triangles.push_back({ next, count + next, count + k });
          }
          source.pieceOfTriangle.assign(source.triangles.size(), 0);
          const Index first = inner ? count : 0;
          for (Index k = 1; k < (inner ? collapsed : std::min<Index>(collapsed, 12)); ++k)
          {
            source.positions[static_cast<std::size_t>(first + k)] =
              source.positions[static_cast<std::size_t>(first)] +
              Point2(width * size * (k % 3), 0.0);
          }
          for (const Index start : { Index(0), count })
          {
            SourceWire border{ {}, WireType::Boundary, none, 0, "boundary" };
            for (Index k = 0; k <= count; ++k)
            {
              border.points.push_back(start + k % count);
            }
            source.wires.push_back(border);
          }
          for (const double tolerance : { 0.2, 1e3 })
          {
            const Smoothed smoothed(source, tolerance);
            EXPECT_LE(smoothed.report().deviation, tolerance);
            for (const Point2& p : smoothed.borders->positions())
            {
              EXPECT_TRUE(p.allFinite());
              EXPECT_LE(p.norm(), 2.0 * size + tolerance);
            }
          }
        }
      }
    }
  }
}

/// Other processors and compilers round otherwise.
TEST(FairBorders, RoundingErrorsDoNotChangeTheCurves)
{
  const int sides = 4;
  const int edges = 60; // of a side
  Points2 corners;
  for (int k = 0; k < sides * edges; ++k)
  {
    // Sides that bulge and wave, each edge of another length.
    const double share = (k % edges + 0.3 * std::sin(3.0 * k)) / edges;
    const double angle = 2.0 * pi / sides * (k / edges + (k % edges == 0 ? 0.0 : share));
    const double radius =
      250.0 + 60.0 * std::sin(pi * share) + 4.0 * std::sin(7.0 * angle) + 0.3 * std::sin(5.0 * k);
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const Smoothed smoothed(polygon(corners), 0.1);
  const auto curve = smoothed.curve(0);
  EXPECT_LT(curve.size(), corners.size() / 2);
  for (const double factor : { 1.0 + 1e-13, 1.0 - 3e-13, 1.0 + 2e-13 })
  {
    Points2 others;
    for (const Point2& corner : corners)
    {
      others.emplace_back(factor * corner);
    }
    const Smoothed other(polygon(others), 0.1);
    const auto same = other.curve(0);
    ASSERT_EQ(same.size(), curve.size());
    for (std::size_t k = 0; k < curve.size(); ++k)
    {
      for (std::size_t c = 0; c < 4; ++c)
      {
        EXPECT_LT((same[k].control[c] - curve[k].control[c]).norm(), 1e-9 * 310.0) << k;
      }
    }
  }
}
