// SPDX-License-Identifier: BSD-3-Clause
// Outlines that are drawn as their own mirror images, measured on what is drawn.
#include "FairShapes.h"

namespace
{
using namespace fairshapes;

constexpr double side = 17.0; ///< of an edge

/// The right side of a shirt from the hem up: a waist, an armhole that is round to the inside, a
/// shoulder, and a half of the neckline. Its edges are equally long.
Points2 rightSide()
{
  Points2 points{ { 150.0, 0.0 } };
  const auto go = [&points](int edges, double angle, double turn) {
    for (int k = 0; k < edges; ++k, angle += turn)
    {
      points.push_back(points.back() + side * Point2(std::cos(angle), std::sin(angle)));
    }
  };
  go(11, 1.75, -0.04);
  go(8, 2.6, -0.17);
  go(5, 2.8, 0.0);
  return points;
}

/// Both sides, the left one with `more` times as many points, which lie on its edges, and longer.
PatternSource shirt(int more, double longer = 1.0)
{
  const Points2 right = rightSide();
  const Point2 centre(0.0, right.back().y() - 40.0);
  Points2 corners(right.begin(), right.end());
  for (double share = 0.85; share > -0.9; share -= 0.17)
  {
    const double across = share * right.back().x();
    corners.emplace_back(across, centre.y() + 40.0 * std::pow(across / right.back().x(), 2.0));
  }
  for (std::size_t k = right.size(); k-- > 0;)
  {
    const Point2 at(-right[k].x(), right[k].y());
    const Point2 last(corners.back());
    for (int part = k + 1 < right.size() ? 1 : more; part <= more; ++part)
    {
      corners.emplace_back(last + static_cast<double>(part) / more * (at - last));
    }
  }
  // The two lowest corners of the left side go down, which makes it longer.
  corners.back() += (longer - 1.0) * (corners.back() - corners[corners.size() - 2]);
  PatternSource source = polygon(corners);
  const auto last = static_cast<Index>(corners.size());
  const auto name = [&](const std::string& curve, Index from, Index to) {
    SourceWire wire{ {}, WireType::Accessory, static_cast<Index>(source.wires.size()), 0, curve };
    for (Index v = from; v <= to; ++v)
    {
      wire.points.push_back(v);
    }
    source.wires.push_back(wire);
  };
  name("right_side", 1, 12);
  name("left_side", last - 11 * more, last);
  return source;
}

PatternOptions symmetrized()
{
  PatternOptions options;
  options.notchSpacing = 100.0;
  options.symmetrize = true;
  return options;
}

Points2 samplesOf(const std::vector<FairSpan>& curve)
{
  Points2 points;
  for (const FairSpan& span : curve)
  {
    sampleSpan(span, 1e-3, points);
  }
  return points;
}

/// How far the image of a curve is from another, at most: of the outline from itself.
double missOf(const Smoothed& smoothed, std::size_t wire = 0, std::size_t other = 0)
{
  const auto curve = smoothed.curve(wire);
  const auto image = smoothed.curve(other);
  const MirrorAxis axis = smoothed.report().mirror.value_or(MirrorAxis());
  double miss = 0.0;
  for (const Point2& p : samplesOf(curve))
  {
    const Point2 foot = axis.at + axis.along.dot(p - axis.at) * axis.along;
    miss = std::max(miss, distanceFrom(image, 2.0 * foot - p));
  }
  return miss;
}

}

TEST(OutlineMirror, BothSidesFollowTheSameCurvesThoughTheirPointsDiffer)
{
  for (const int more : { 1, 2, 3 })
  {
    if (more > 1)
    {
      EXPECT_GT(missOf(Smoothed(shirt(more), 0.5)), 0.002) << more;
    }
    const Smoothed smoothed(shirt(more), 0.5, 60.0, symmetrized());
    ASSERT_TRUE(smoothed.report().mirror) << more;
    EXPECT_LT(missOf(smoothed), 2e-5) << more; // what chords of the measure leave
    EXPECT_LT(smoothed.report().mirrorMiss, 1e-7) << more;
    EXPECT_GT(smoothed.report().splines, 3U) << more;
  }
}

TEST(OutlineMirror, NoPointIsFartherThanTheTolerance)
{
  const Smoothed smoothed(shirt(2), 0.5, 60.0, symmetrized());
  const auto curve = smoothed.curve(0);
  double most = 0.0;
  for (const Index v : smoothed.source.wires[0].points)
  {
    most =
      std::max(most, distanceFrom(curve, smoothed.source.positions[static_cast<std::size_t>(v)]));
  }
  EXPECT_LE(most, 0.5 + 1e-5);
  EXPECT_NEAR(most, smoothed.report().deviation, 0.02);
}

TEST(OutlineMirror, EveryIntervalKeepsItsLengthThoughNotchesOfBothSidesDiffer)
{
  const double length = 11 * side;
  std::map<std::string, std::vector<double>> notches;
  notches["right_side"] = { 40.0, 95.0, 150.0 };
  notches["left_side"] = { 61.0, 92.5, length - 40.2 };
  PatternOptions options = symmetrized();
  options.notchesOfCurve = notches;
  const Smoothed smoothed(shirt(2), 0.5, 0.0, options);
  ASSERT_TRUE(smoothed.report().mirror);
  for (const std::size_t wire : { 1U, 2U })
  {
    const SourceWire& own = smoothed.source.wires[wire];
    const double edge = length / static_cast<double>(own.points.size() - 1);
    notches[own.name].push_back(length);
    for (const double notch : notches[own.name])
    {
      double way = 0.0;
      for (std::size_t k = 0; k + 1 < own.points.size(); ++k)
      {
        const double part = std::clamp(notch / edge - static_cast<double>(k), 0.0, 1.0);
        way += lengthOf(smoothed.borders->alongEdge(own.points[k], own.points[k + 1], 0.0, part));
      }
      EXPECT_NEAR(way, notch, 1e-8) << own.name;
    }
  }
}

TEST(OutlineMirror, SidesThatDifferLittleGetTheirMeanAndOthersAreRefusedByName)
{
  const double length = 11 * side;
  const Smoothed smoothed(shirt(1, 1.0 + 0.06 / side), 0.5, 0.0, symmetrized());
  const FairPieceReport& report = smoothed.report();
  ASSERT_TRUE(report.mirror) << report.whyNotMirrored;
  for (const std::size_t wire : { 1U, 2U })
  {
    EXPECT_NEAR(lengthOf(smoothed.curve(wire)), length + 0.03, 1e-8);
  }
  EXPECT_NEAR(report.lengthDifference, 0.06, 1e-9);
  EXPECT_NEAR(report.lengthChange, 0.03, 1e-9);
  EXPECT_LT(missOf(smoothed), 2e-5);

  const Smoothed refused(shirt(1, 1.0 + 0.3 / side), 0.5, 0.0, symmetrized());
  const FairPieceReport& other = refused.report();
  EXPECT_FALSE(other.mirror);
  EXPECT_EQ(other.whyNotMirrored,
    "stretches of right_side and left_side that are mirror images differ by 0.3 mm in length, more "
    "than 0.1 mm");
  EXPECT_NEAR(lengthOf(refused.curve(2)), length + 0.3, 1e-8);
  EXPECT_EQ(other.lengthChange, 0.0);
}

TEST(OutlineMirror, WhatIsSewnToASideGetsItsLength)
{
  PatternSource source = shirt(1, 1.0 + 0.06 / side);
  // A piece whose border has the edges of the right side, and two more.
  const auto first = static_cast<Index>(source.positions.size());
  const Points2 edge = rightSide();
  SourceWire seam{ {}, WireType::Seam, 7, 1, "seam" };
  for (Index k = 0; k < 12; ++k)
  {
    source.positions.push_back(Point2(400.0, 0.0) - edge[static_cast<std::size_t>(k)]);
    seam.points.push_back(first + k);
  }
  source.positions.emplace_back(500.0, -90.0);
  for (Index k = 0; k < 11; ++k)
  {
    source.triangles.push_back({ first + k, first + k + 1, first + 12 });
    source.pieceOfTriangle.push_back(1);
    source.sewn.push_back({ { 1 + k, 2 + k }, { first + k, first + k + 1 } });
  }
  source.wires.push_back(seam);
  source.wires.push_back(
    { { first + 11, first + 12, first }, WireType::Boundary, none, 1, "boundary" });
  const Smoothed smoothed(source, 0.5, 70.0, symmetrized());
  const auto lengthOfWire = [&smoothed](
                              std::size_t wire) { return lengthOf(smoothed.curve(wire)); };
  ASSERT_TRUE(smoothed.report().mirror);
  EXPECT_FALSE(smoothed.borders->reports()[1].mirror);
  EXPECT_NEAR(lengthOfWire(1), lengthOfWire(2), 1e-9);
  EXPECT_NEAR(lengthOfWire(1), lengthOfWire(3), 1e-9);
  // The mean of 187, 187.06 and 187.
  EXPECT_NEAR(lengthOfWire(3), 187.02, 1e-8);
  EXPECT_NEAR(smoothed.borders->reports()[1].lengthChange, lengthOfWire(3) - 187.0, 1e-9);
}

TEST(OutlineMirror, CurvesWithinEndOnTheSymmetricBorderAtTheirLengths)
{
  for (const Index end : { 31, 60, 76, 77 }) // the last is the image of the start, one is beside it
  {
    PatternSource source = shirt(2);
    source.wires.push_back({ { 5, 0, end }, WireType::Accessory, 9, 0, "within" });
    const Smoothed smoothed(source, 0.5, 0.0, symmetrized());
    ASSERT_TRUE(smoothed.report().mirror) << end;
    EXPECT_LT(missOf(smoothed), 2e-5) << end;
    const auto curve = smoothed.curve(3);
    const Point2 first = smoothed.borders->alongEdge(5, 6).front().control[0];
    const Point2 last = smoothed.borders->alongEdge(end, end + 1).front().control[0];
    EXPECT_NEAR((curve.front().control[0] - first).norm(), 0.0, 1e-6) << end;
    EXPECT_NEAR((curve.back().control[3] - last).norm(), 0.0, 1e-6) << end;
  }
}
