// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/Grainlines.h"

#include "DrawnPieces.h"
#include "Outlines/PlaneGeometry.h"

namespace
{
using namespace drawnpieces;

/// A rectangle of 60 x 100 mm that stands in space, 100 high along an axis, and lies in the plane
/// turned by an angle.
PatternSource standingRectangle(double angle, int up)
{
  PatternSource source;
  for (const Point2& p :
    { Point2(0.0, 0.0), Point2(60.0, 0.0), Point2(60.0, 100.0), Point2(0.0, 100.0) })
  {
    source.positions.emplace_back(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
      std::sin(angle) * p.x() + std::cos(angle) * p.y());
    Point3 x(p.x(), 0.0, 0.0);
    x[up] = p.y();
    source.inSpace.push_back(x);
  }
  source.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  source.pieceOfTriangle = { 0, 0 };
  source.wires = { { { 0, 1, 2, 3, 0 }, WireType::Boundary, none, 0, "boundary" } };
  return source;
}

PatternPiece drawnUp(const PatternSource& source, UpAxis axis)
{
  PatternOptions options = inMillimetres(0.0);
  options.up = axis;
  return drawn(source, options);
}
}

TEST(Grainlines, APieceStandsAsItDoesInSpace)
{
  for (const int up : { 1, 2 })
  {
    for (const double angle : { 0.0, 0.7, 2.5, 4.0 })
    {
      const PatternPiece piece = drawnUp(standingRectangle(angle, up), UpAxis::Automatic);
      EXPECT_NEAR(piece.extent.x(), 60.0, 1e-3);
      EXPECT_NEAR(piece.extent.y(), 100.0, 1e-3);
      EXPECT_TRUE(piece.grain.known);
      EXPECT_NEAR(piece.grain.from.x(), piece.grain.to.x(), 1e-9);
      EXPECT_GT(piece.grain.to.y(), piece.grain.from.y());
      EXPECT_TRUE(says(piece, "grain"));
    }
  }
}

TEST(Grainlines, AnAxisMayBeNamedOrNone)
{
  const PatternSource source = standingRectangle(0.7, 2);
  EXPECT_NEAR(drawnUp(source, UpAxis::X).extent.x(), 100.0, 1e-3);
  // Level along y: it has no up, and lies as it did.
  for (const UpAxis axis : { UpAxis::Y, UpAxis::None })
  {
    const PatternPiece piece = drawnUp(source, axis);
    EXPECT_NEAR(piece.extent.y(), 100.0 * std::cos(0.7) + 60.0 * std::sin(0.7), 1e-3);
    EXPECT_FALSE(piece.grain.known);
  }
}

TEST(Grainlines, AStraightKeyCurveGoesBeforeTheUpOfTheSurface)
{
  PatternSource source = standingRectangle(0.7, 2);
  source.wires.push_back({ { 0, 2 }, WireType::Key, 0, 0, "bias" });
  const PatternPiece piece = drawnUp(source, UpAxis::Automatic);
  const Point2 grain = (piece.grain.to - piece.grain.from).normalized();
  const Point2 bias = (source.positions[2] - source.positions[0]).normalized();
  EXPECT_NEAR(std::abs(cross(grain, bias)), 0.0, 1e-9);
}

TEST(Grainlines, PiecesAreLongerAlongThemAndAcrossAsCompensationSays)
{
  PatternOptions options = inMillimetres(0.0);
  options.warpCompensation = 10.0;
  options.weftCompensation = -5.0;
  for (const double angle : { 0.0, 0.7, 4.0 })
  {
    const PatternPiece piece = drawn(standingRectangle(angle, 2), options);
    EXPECT_NEAR(piece.extent.x(), 57.0, 1e-3);
    EXPECT_NEAR(piece.extent.y(), 110.0, 1e-3);
    EXPECT_TRUE(says(piece, "drawn longer by 10 % along the warp"));
    EXPECT_TRUE(says(piece, "drawn shorter by 5 % along the weft"));
  }
  // Along the diagonal, where that is the grain.
  PatternSource source = standingRectangle(0.7, 2);
  source.wires.push_back({ { 0, 2 }, WireType::Key, 0, 0, "bias" });
  const PatternLine bias = lineOf(drawn(source, options), LineKind::KeyCurve);
  EXPECT_NEAR(lengthOf(bias), 1.1 * std::hypot(60.0, 100.0), 1e-9);
}

TEST(Grainlines, EndAtABorderThatTheyMeetInACorner)
{
  for (int k = 1; k < 1000; ++k)
  {
    const Point2 from(0.1 * k, std::sin(k));
    const Point2 corner(10.0 * std::cos(k), 7.0 + k);
    const Segments border{ { from + Point2(-200.0, 90.0), corner },
      { corner, from + Point2(300.0, 70.0) } };
    const std::vector<double> met = crossings(from, corner - from, border);
    ASSERT_EQ(met.size(), 1U) << k;
    EXPECT_NEAR(met[0], 1.0, 1e-12);
  }
}
