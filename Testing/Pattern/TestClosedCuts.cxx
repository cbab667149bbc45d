// SPDX-License-Identifier: BSD-3-Clause
// A square with a dart that was closed at its mouth, or all along.
#include "DrawnPieces.h"

namespace
{
using namespace drawnpieces;

/// A square of 200, in millimetres, with a dart from the middle of its upper side down to (100,
/// 80). Both banks lie on each other from the mouth to (100, 160); from there to the tip they are
/// up to `width` apart.
PatternSource square(double width)
{
  // 0..3 corners; 4, 5, 6 the right side of the cut, 7 the tip, 8, 9, 10 the left one.
  return onePiece(
    { { 0.0, 0.0 }, { 200.0, 0.0 }, { 200.0, 200.0 }, { 0.0, 200.0 }, { 100.0, 200.0 },
      { 100.0, 160.0 }, { 100.0 + width / 2.0, 120.0 }, { 100.0, 80.0 },
      { 100.0 - width / 2.0, 120.0 }, { 100.0, 160.0 }, { 100.0, 200.0 } },
    { { 0, 1, 7 }, { 2, 4, 5 }, { 2, 5, 6 }, { 2, 6, 7 }, { 2, 7, 1 }, { 3, 0, 7 }, { 3, 7, 8 },
      { 3, 8, 9 }, { 3, 9, 10 } },
    { { { 4, 2, 1, 0, 3, 10 }, WireType::Boundary, none, 0, "boundary" },
      { { 4, 5, 6, 7 }, WireType::Dart, 0, 0, "dart" },
      { { 10, 9, 8, 7 }, WireType::Dart, 0, 0, "dart" } },
    { { { 4, 5 }, { 10, 9 }, true }, { { 5, 6 }, { 9, 8 }, width == 0.0 },
      { { 6, 7 }, { 8, 7 }, width == 0.0 } });
}

PatternPiece drawnPlainly(const PatternSource& source)
{
  PatternOptions options = inMillimetres(0.0);
  options.notchSpacing = 0.0;
  return drawnpieces::drawn(source, options);
}
}

TEST(ClosedCuts, ADartClosedAllAlongIsWholeCloth)
{
  const PatternPiece piece = drawnPlainly(square(0.0));
  EXPECT_TRUE(linesOf(piece, LineKind::DartLeg).empty());
  EXPECT_TRUE(linesOf(piece, LineKind::DartFold).empty());
  EXPECT_TRUE(piece.drillHoles.empty());
  EXPECT_TRUE(piece.notches.empty());
  EXPECT_NEAR(areaOf(lineOf(piece, LineKind::CutLine).points), 200.0 * 200.0, 1e-6);
}

TEST(ClosedCuts, ADartClosedAtItsMouthIsFoldedBetweenTwoTips)
{
  const PatternPiece piece = drawnPlainly(square(10.0));
  const auto legs = linesOf(piece, LineKind::DartLeg);
  ASSERT_EQ(legs.size(), 2U);
  for (const PatternLine& leg : legs)
  {
    EXPECT_EQ(leg.points.size(), 3U);
    EXPECT_EQ(leg.points.front(), Point2(100.0, 160.0));
    EXPECT_EQ(leg.points.back(), Point2(100.0, 80.0));
  }
  EXPECT_EQ(linesOf(piece, LineKind::DartFold).size(), 1U);
  EXPECT_EQ(piece.drillHoles.size(), 2U);
  EXPECT_TRUE(piece.notches.empty());
  EXPECT_TRUE(linesOf(piece, LineKind::CutOut).empty());
}
