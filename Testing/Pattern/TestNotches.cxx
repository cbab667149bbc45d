// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnPieces.h"

namespace
{
using namespace drawnpieces;

/// A square of 200 whose lower side, from right to left, is an edge with a name. Unit: millimetre.
PatternSource squareWithHem()
{
  return onePiece(
    { { 0.0, 0.0 }, { 120.0, 0.0 }, { 200.0, 0.0 }, { 200.0, 200.0 }, { 0.0, 200.0 } },
    { { 0, 1, 4 }, { 1, 3, 4 }, { 1, 2, 3 } },
    { { { 2, 3, 4, 0 }, WireType::Boundary, none, 0, "boundary" },
      { { 2, 1, 0 }, WireType::Accessory, 0, 0, "hem" } });
}

/// Two squares of 200, each with a point in the middle of the seam between them.
PatternSource sewnSquares()
{
  PatternSource source;
  for (const double left : { 0.0, 300.0 })
  {
    const auto first = static_cast<Index>(source.positions.size());
    const Index piece = first == 0 ? 0 : 1;
    const double seam = first == 0 ? 200.0 : 300.0;
    for (const Point2& p : { Point2(left, 0.0), Point2(left + 200.0, 0.0),
           Point2(left + 200.0, 200.0), Point2(left, 200.0), Point2(seam, 100.0) })
    {
      source.positions.push_back(p);
    }
    const std::vector<Triangle> triangles = first == 0
      ? std::vector<Triangle>{ { 0, 1, 4 }, { 4, 2, 3 }, { 0, 4, 3 } }
      : std::vector<Triangle>{ { 5, 6, 9 }, { 6, 7, 9 }, { 7, 8, 9 } };
    source.triangles.insert(source.triangles.end(), triangles.begin(), triangles.end());
    source.pieceOfTriangle.resize(source.triangles.size(), piece);
  }
  source.wires = { { { 1, 4, 2 }, WireType::Seam, 0, 0, "side" },
    { { 5, 9, 8 }, WireType::Seam, 0, 1, "side" },
    { { 2, 3, 0, 1 }, WireType::Boundary, none, 0, "boundary" },
    { { 5, 6, 7, 8 }, WireType::Boundary, none, 1, "boundary" } };
  source.sewn = { { { 1, 4 }, { 5, 9 } }, { { 4, 2 }, { 9, 8 } } };
  return source;
}

PatternOptions hemOptions(const std::map<std::string, std::vector<double>>& notches = {})
{
  PatternOptions options = inMillimetres();
  options.allowanceOfCurve = { { "hem", 40.0 } };
  options.notchesOfCurve = notches;
  return options;
}
}

TEST(Notches, AnEdgeHasThemWhereTheyAreAskedFor)
{
  const PatternPiece piece = drawn(squareWithHem(), hemOptions({ { "hem", { 150.0, 30.0 } } }));
  ASSERT_EQ(piece.notches.size(), 2U);
  // The allowance is 10 mm on the left and 40 mm below.
  EXPECT_NEAR(piece.notches[0].foot.x(), 10.0 + 170.0, 1e-3);
  EXPECT_NEAR(piece.notches[1].foot.x(), 10.0 + 50.0, 1e-3);
  EXPECT_NEAR(piece.notches[0].foot.y(), 40.0, 1e-3);
  EXPECT_NEAR(piece.notches[0].from.y(), 0.0, 1e-3);
  EXPECT_EQ(piece.notches[1].arcLength, 150.0);
}

TEST(Notches, DoubleOnesAreTwoMarksAroundTheirPlace)
{
  PatternOptions options = hemOptions({ { "hem", { 150.0, 30.0 } } });
  options.doubleNotches = { "hem" };
  const PatternPiece piece = drawn(squareWithHem(), options);
  std::vector<double> feet;
  for (const Notch& notch : piece.notches)
  {
    feet.push_back(notch.foot.x() - 10.0);
    EXPECT_NEAR(notch.from.y(), 0.0, 1e-3);
  }
  std::sort(feet.begin(), feet.end());
  ASSERT_EQ(feet.size(), 4U);
  const double half = 25.4 / 8.0; // a quarter of an inch
  for (std::size_t k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(feet[k], (k < 2 ? 50.0 : 170.0) + (k % 2 == 0 ? -half : half), 1e-3);
  }
}

TEST(Notches, DoubleOnesLieOppositeEachOtherOnBothSidesOfASeam)
{
  PatternOptions options = hemOptions();
  options.allowanceOfCurve.clear();
  options.doubleNotches = { "side" };
  const Pattern pattern = patternOf(sewnSquares(), options);
  ASSERT_EQ(pattern.pieces.size(), 2U);
  for (const PatternPiece& piece : pattern.pieces)
  {
    // One for each 100 mm of 200, but off the middle, the other would be at the end.
    ASSERT_EQ(piece.notches.size(), 2U);
    EXPECT_NEAR(piece.notches[0].foot.y(), 10.0 + 80.0 - 25.4 / 8.0, 1e-3);
    EXPECT_NEAR(piece.notches[1].foot.y(), 10.0 + 80.0 + 25.4 / 8.0, 1e-3);
  }
}

TEST(Notches, TellWhichEndOfASeamIsWhich)
{
  // 200 mm: the notches at each of these would be the same from either end but for the last one.
  for (const double spacing : { 300.0, 100.0, 50.0, 70.0 })
  {
    PatternOptions options = inMillimetres();
    options.notchSpacing = spacing;
    std::vector<std::vector<double>> places;
    for (const PatternPiece& piece : patternOf(sewnSquares(), options).pieces)
    {
      std::vector<double>& own = places.emplace_back();
      for (const Notch& notch : piece.notches)
      {
        own.push_back(notch.foot.y() - 10.0);
      }
      std::sort(own.begin(), own.end());
      ASSERT_FALSE(own.empty());
      EXPECT_GT(std::abs(own.front() - (200.0 - own.back())), 9.9) << spacing;
    }
    ASSERT_EQ(places.size(), 2U);
    ASSERT_EQ(places[0].size(), places[1].size());
    for (std::size_t k = 0; k < places[0].size(); ++k)
    {
      EXPECT_NEAR(places[0][k], places[1][k], 1e-9);
    }
  }
}

TEST(Notches, AtCornersBothSewLinesGoOnToTheCutLine)
{
  PatternOptions options = hemOptions();
  options.notchCorners = true;
  const PatternPiece piece = drawn(squareWithHem(), options);
  ASSERT_EQ(piece.notches.size(), 8U);
  for (const Notch& notch : piece.notches)
  {
    const Point2 way = notch.from - notch.foot;
    const bool isDown = way.y() < -1.0;
    EXPECT_NEAR(way.norm(), isDown ? 40.0 : 10.0, 1e-3);
    EXPECT_NEAR(std::min(std::abs(way.x()), std::abs(way.y())), 0.0, 1e-9);
    // The corners of the square.
    EXPECT_NEAR(std::abs(notch.foot.x() - 110.0), 100.0, 1e-3);
    EXPECT_NEAR(std::abs(notch.foot.y() - 140.0), 100.0, 1e-3);
  }
}

TEST(Notches, WhereACurveMeetsTheBorderOfThePieceThatIsSewnOn)
{
  PatternOptions options = hemOptions();
  options.allowanceOfCurve.clear();
  options.notchSpacing = 0.0;
  options.notchCurveEnds = true;
  PatternSource source = sewnSquares();
  source.wires.push_back({ { 4, 3 }, WireType::Accessory, 1, 0, "girth" });
  const Pattern pattern = patternOf(source, options);
  ASSERT_EQ(pattern.pieces.size(), 2U);
  // The girth starts in the middle of the seam and ends in a corner.
  for (const PatternPiece& piece : pattern.pieces)
  {
    ASSERT_EQ(piece.notches.size(), 1U);
    EXPECT_EQ(piece.notches[0].name, "girth");
    EXPECT_NEAR(piece.notches[0].foot.y(), 10.0 + 100.0, 1e-3);
    EXPECT_NEAR((piece.notches[0].from - piece.notches[0].foot).norm(), 10.0, 1e-3);
  }
}

TEST(Notches, ANamedEdgeIsASewLine)
{
  const PatternPiece piece = drawn(squareWithHem(), hemOptions());
  EXPECT_TRUE(piece.notches.empty());
  int named = 0;
  for (const PatternLine& line : piece.lines)
  {
    named += line.name == "hem" && line.kind == LineKind::SewLine ? 1 : 0;
    EXPECT_NE(line.kind, LineKind::Internal);
  }
  EXPECT_EQ(named, 1);
}

TEST(Notches, OneBeyondTheEndOfItsCurveOrOfNoneIsRefused)
{
  expectRefusal(squareWithHem(), hemOptions({ { "hem", { 201.0 } } }), { "hem", "201", "200 mm" });
  expectRefusal(squareWithHem(), hemOptions({ { "cuff", { 1.0 } } }), { "cuff", "hem" });
}
