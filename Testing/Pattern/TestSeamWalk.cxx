// SPDX-License-Identifier: BSD-3-Clause
// Walks whose lengths and angles are known by construction.
#include "DrawnPieces.h"

namespace
{
using namespace drawnpieces;

constexpr double degrees = 57.295779513082320877;

const double legLength = std::hypot(20.0, 120.0); ///< of the dart

/// Two triangles that are sewn along a side of 100 in two edges; the second one's is longer by 10
/// in its upper half, and stands on a corner of 45 degrees, not on one of 90.
PatternSource twoTriangles()
{
  PatternSource source;
  source.positions = { { 0.0, 0.0 }, { 100.0, 0.0 }, { 100.0, 50.0 }, { 100.0, 100.0 },
    { 300.0, 0.0 }, { 300.0, 50.0 }, { 300.0, 110.0 }, { 410.0, 110.0 } };
  source.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 7, 5 }, { 5, 7, 6 } };
  source.pieceOfTriangle = { 0, 0, 1, 1 };
  source.wires = { { { 1, 2, 3 }, WireType::Seam, 0, 0, "side, \"left\"" },
    { { 4, 5, 6 }, WireType::Seam, 0, 1, "side, \"left\"" } };
  source.sewn = { { { 1, 2 }, { 4, 5 } }, { { 2, 3 }, { 5, 6 } } };
  return source;
}

PatternOptions withSpacing(double spacing)
{
  PatternOptions options = inMillimetres();
  options.notchSpacing = spacing;
  return options;
}

std::vector<WalkInterval> walkOf(const PatternSource& source, double spacing)
{
  std::vector<WalkInterval> walk;
  EXPECT_TRUE(drawnpieces::walk(source, withSpacing(spacing), walk).ok());
  return walk;
}
}

TEST(SeamWalk, LegsOfADartAreWalkedFromMouthToTip)
{
  const auto walk = walkOf(dartedSquare(), 0.0);
  ASSERT_EQ(walk.size(), 1U);
  EXPECT_NEAR(walk[0].length[0], legLength, 1e-12);
  EXPECT_NEAR(walk[0].length[1], legLength, 1e-12);
  EXPECT_EQ(walk[0].from, 0.0);
  EXPECT_NEAR(walk[0].to, legLength, 1e-12);
  const double opening = 2.0 * degrees * std::atan2(20.0, 120.0);
  EXPECT_NEAR(walk[0].angleSum[0], 180.0 + opening, 1e-9); // at the mouth
  EXPECT_NEAR(walk[0].angleSum[1], 360.0 - opening, 1e-9); // at the tip, one point
}

TEST(SeamWalk, LegsWithTheirTipDrawnBackAreWalkedAsTheyAreDrawn)
{
  for (const double spacing : { 0.0, 50.0 })
  {
    PatternOptions options = withSpacing(spacing);
    options.dartTip = 30.0;
    std::vector<WalkInterval> walk;
    ASSERT_TRUE(drawnpieces::walk(dartedSquare(), options, walk).ok());
    const double shorter = std::hypot(20.0, 90.0); // the tip stands 90 mm from the mouth then
    std::array<double, 2> length{};
    for (const WalkInterval& interval : walk)
    {
      // Along the leg, an affine map keeps the shares that intervals have of it.
      const double share = (interval.to - interval.from) / legLength;
      for (std::size_t s = 0; s < 2; ++s)
      {
        EXPECT_NEAR(interval.length[s], share * shorter, 1e-12);
        length[s] += interval.length[s];
      }
    }
    EXPECT_NEAR(length[0], shorter, 1e-12);
    EXPECT_NEAR(length[1], shorter, 1e-12);
    const double opening = 2.0 * degrees * std::atan2(20.0, 90.0);
    EXPECT_NEAR(walk.front().angleSum[0], 180.0 + opening, 1e-9);
    EXPECT_NEAR(walk.back().angleSum[1], 360.0 - opening, 1e-9);
    options.cutDartsOut = true; // nothing is drawn back
    ASSERT_TRUE(drawnpieces::walk(dartedSquare(), options, walk).ok());
    EXPECT_NEAR(walk.back().angleSum[1], 360.0 - 2.0 * degrees * std::atan2(20.0, 120.0), 1e-9);
  }
}

TEST(SeamWalk, IntervalsEndAtTheNotches)
{
  const auto walk = walkOf(dartedSquare(), 50.0);
  ASSERT_EQ(walk.size(), 3U);
  EXPECT_NEAR(walk[0].to, 50.0, 1e-12);
  EXPECT_NEAR(walk[1].from, 50.0, 1e-12);
  EXPECT_NEAR(walk[1].length[1], 50.0, 1e-12);
  EXPECT_NEAR(walk[2].length[0], legLength - 100.0, 1e-12);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(walk[k].number, k + 1);
  }
}

TEST(SeamWalk, SidesOfDifferentLengthsAreMeasuredEachOnItsPiece)
{
  const auto walk = walkOf(twoTriangles(), 0.0);
  ASSERT_EQ(walk.size(), 1U);
  EXPECT_EQ(walk[0].piece, (std::array<std::size_t, 2>{ 0, 1 }));
  EXPECT_NEAR(walk[0].length[0], 100.0, 1e-12);
  EXPECT_NEAR(walk[0].length[1], 110.0, 1e-12);
  EXPECT_NEAR(walk[0].angleSum[0], 90.0 + 45.0, 1e-9);
  EXPECT_NEAR(walk[0].angleSum[1], 45.0 + 90.0, 1e-9);
}

TEST(SeamWalk, TheTableHoldsWhatWasWalked)
{
  Pattern pattern;
  pattern.names = { "front", "back" };
  const std::string table = makeWalkTable(walkOf(twoTriangles(), 0.0), pattern);
  EXPECT_NE(
    table.find(
      "\n\"side, \"\"left\"\"\",seam,front,back,1,0,100,100,110,-10,-9.090909,135,135,A,\n"),
    std::string::npos)
    << table;
}

TEST(SeamWalk, NotchesWithoutNumberAreRefusedWithTheirCurve)
{
  std::vector<WalkInterval> walk;
  const Status status = drawnpieces::walk(dartedSquare(), withSpacing(1e-9), walk);
  EXPECT_EQ(status.code, StatusCode::InvalidOption);
  EXPECT_NE(status.message.find("dart"), std::string::npos);
}
