// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PatternBuilder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace flattening;
using namespace flattening::pattern;

/// A square of 200 whose lower side, from right to left, is an edge with a name. Unit: millimetre.
PatternSource squareWithHem()
{
  PatternSource source;
  source.positions = { { 0.0, 0.0 }, { 120.0, 0.0 }, { 200.0, 0.0 }, { 200.0, 200.0 },
    { 0.0, 200.0 } };
  source.triangles = { { 0, 1, 4 }, { 1, 3, 4 }, { 1, 2, 3 } };
  source.pieceOfTriangle.assign(source.triangles.size(), 0);
  source.wires = { { { 2, 3, 4, 0 }, WireType::Boundary, none, 0, "boundary" },
    { { 2, 1, 0 }, WireType::Accessory, 0, 0, "hem" } };
  return source;
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

PatternOptions hemOptions()
{
  PatternOptions options;
  options.fairTolerance = 0.0;
  options.notchSpacing = 100.0;
  options.unit = Unit::Millimetre;
  options.allowanceOfCurve = { { "hem", 40.0 } };
  return options;
}

PatternPiece build(const PatternSource& source, const PatternOptions& options)
{
  Pattern pattern;
  const Status status = buildPattern(source, options, pattern);
  EXPECT_TRUE(status.ok()) << status.message;
  return pattern.pieces.empty() ? PatternPiece() : pattern.pieces[0];
}

Status build(const std::map<std::string, std::vector<double>>& notches, Pattern& pattern)
{
  PatternOptions options = hemOptions();
  options.notchesOfCurve = notches;
  return buildPattern(squareWithHem(), options, pattern);
}
}

TEST(Notches, AnEdgeHasThemWhereTheyAreAskedFor)
{
  Pattern pattern;
  ASSERT_TRUE(build({ { "hem", { 150.0, 30.0 } } }, pattern).ok());
  const PatternPiece& piece = pattern.pieces[0];
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
  PatternOptions options = hemOptions();
  options.notchesOfCurve = { { "hem", { 150.0, 30.0 } } };
  options.doubleNotches = { "hem" };
  const PatternPiece piece = build(squareWithHem(), options);
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
  Pattern pattern;
  ASSERT_TRUE(buildPattern(sewnSquares(), options, pattern).ok());
  ASSERT_EQ(pattern.pieces.size(), 2U);
  for (const PatternPiece& piece : pattern.pieces)
  {
    // One at 100 mm of 200, the other would be at the end.
    ASSERT_EQ(piece.notches.size(), 2U);
    EXPECT_NEAR(piece.notches[0].foot.y(), 10.0 + 100.0 - 25.4 / 8.0, 1e-3);
    EXPECT_NEAR(piece.notches[1].foot.y(), 10.0 + 100.0 + 25.4 / 8.0, 1e-3);
  }
}

TEST(Notches, AtCornersBothSewLinesGoOnToTheCutLine)
{
  PatternOptions options = hemOptions();
  options.notchCorners = true;
  const PatternPiece piece = build(squareWithHem(), options);
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
  Pattern pattern;
  ASSERT_TRUE(buildPattern(source, options, pattern).ok());
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
  Pattern pattern;
  ASSERT_TRUE(build({}, pattern).ok());
  EXPECT_TRUE(pattern.pieces[0].notches.empty());
  int named = 0;
  for (const PatternLine& line : pattern.pieces[0].lines)
  {
    named += line.name == "hem" && line.kind == LineKind::SewLine ? 1 : 0;
    EXPECT_NE(line.kind, LineKind::Internal);
  }
  EXPECT_EQ(named, 1);
}

TEST(Notches, OneBeyondTheEndOfItsCurveIsRefusedWithBothLengths)
{
  Pattern pattern;
  const Status status = build({ { "hem", { 201.0 } } }, pattern);
  EXPECT_EQ(status.code, StatusCode::InvalidOption);
  for (const char* word : { "hem", "201", "200 mm" })
  {
    EXPECT_NE(status.message.find(word), std::string::npos) << status.message;
  }
}

TEST(Notches, OneOfACurveThatIsNotThereIsRefused)
{
  Pattern pattern;
  const Status status = build({ { "cuff", { 1.0 } } }, pattern);
  EXPECT_EQ(status.code, StatusCode::InvalidOption);
  EXPECT_NE(status.message.find("cuff"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find("hem"), std::string::npos) << status.message;
}
