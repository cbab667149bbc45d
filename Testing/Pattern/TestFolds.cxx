// SPDX-License-Identifier: BSD-3-Clause
// Pieces cut on the fold, whose numbers are known by construction.
#include "DrawnPieces.h"

namespace
{
using namespace drawnpieces;

/// A trapezium of height 300 about x = 100 with its centre line. Unit: millimetre.
/// \param askew how far a corner is moved along the upper side
/// \param bend how far the middle of the centre line is moved across
PatternSource trapezium(double askew, double bend = 0.0)
{
  return onePiece({ { 0.0, 0.0 }, { 100.0, 0.0 }, { 200.0, 0.0 }, { 150.0 + askew, 300.0 },
                    { 100.0, 300.0 }, { 50.0, 300.0 }, { 100.0 + bend, 150.0 } },
    { { 0, 1, 6 }, { 0, 6, 5 }, { 6, 4, 5 }, { 1, 2, 6 }, { 2, 3, 6 }, { 3, 4, 6 } },
    { { { 0, 1, 2, 3, 4, 5, 0 }, WireType::Boundary, none, 0, "boundary" },
      { { 1, 6, 4 }, WireType::Key, 0, 0, "centre" } });
}

/// Its right half, with the centre line on its border.
PatternSource halfOfIt()
{
  return onePiece({ { 100.0, 0.0 }, { 200.0, 0.0 }, { 150.0, 300.0 }, { 100.0, 300.0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } },
    { { { 0, 1, 2, 3 }, WireType::Boundary, none, 0, "boundary" },
      { { 3, 0 }, WireType::Accessory, 0, 0, "centre" } });
}

PatternOptions onFold(const std::string& curve)
{
  PatternOptions options = inMillimetres();
  options.pieceNames = { "front" };
  options.foldsAlong = { curve };
  return options;
}

/// A trapezium, upright and symmetric about x = 100, with a line across it. Unit: millimetre.
PatternSource beltedTrapezium(double askew)
{
  return onePiece({ { 0.0, 0.0 }, { 200.0, 0.0 }, { 150.0 + askew, 300.0 }, { 50.0, 300.0 },
                    { 20.0, 120.0 }, { 180.0, 120.0 } },
    { { 0, 1, 5 }, { 0, 5, 4 }, { 4, 5, 2 }, { 4, 2, 3 } },
    { { { 0, 1, 5, 2, 3, 4, 0 }, WireType::Boundary, none, 0, "boundary" },
      { { 4, 5 }, WireType::Accessory, 0, 0, "waist" } });
}

PatternOptions wherePiecesAreSymmetric()
{
  PatternOptions options = inMillimetres();
  options.cutOnFold = true;
  return options;
}

/// A half of the trapezium, of height 320, with its fold at x = 0.
void expectFold(const PatternPiece& piece, double within)
{
  EXPECT_NEAR(piece.extent.y(), 320.0, 1e-3);
  const PatternLine fold = lineOf(piece, LineKind::Fold);
  for (const Point2& p : fold.points)
  {
    EXPECT_NEAR(p.x(), 0.0, within);
  }
  EXPECT_NEAR((fold.points[1] - fold.points[0]).norm(), 320.0, 1e-3);
  EXPECT_TRUE(says(piece, "cut 1 on fold"));
}
}

TEST(SymmetricFolds, LinesThatRunAcrossTheFoldAreHalved)
{
  const PatternPiece piece = drawn(beltedTrapezium(0.0), wherePiecesAreSymmetric());
  const PatternLine waist = lineOf(piece, LineKind::Internal);
  EXPECT_NEAR((waist.points.back() - waist.points.front()).norm(), 80.0, 1e-9);
  EXPECT_NEAR(waist.restLength, 80.0, 1e-9);
  const PatternLine fold = lineOf(piece, LineKind::Fold);
  // With an allowance of 10 mm at both ends.
  EXPECT_NEAR((fold.points.back() - fold.points.front()).norm(), 320.0, 1e-3);
  EXPECT_NEAR(fold.points.front().x(), fold.points.back().x(), 1e-9);
  const PatternLine sew = lineOf(piece, LineKind::SewLine);
  EXPECT_FALSE(sew.closed);
  EXPECT_NEAR(sew.restLength, 100.0 + std::hypot(50.0, 300.0) + 50.0, 0.2);
  EXPECT_TRUE(says(piece, "cut 1 on fold"));
  // The cut line and its mirror image are the whole piece.
  EXPECT_NEAR(2.0 * areaOf(lineOf(piece, LineKind::CutLine).points),
    areaOf(lineOf(drawn(beltedTrapezium(0.0), inMillimetres()), LineKind::CutLine).points), 0.5);
}

TEST(SymmetricFolds, APieceThatIsNotSymmetricIsDrawnWholeAndSaysSo)
{
  const PatternPiece piece = drawn(beltedTrapezium(5.0), wherePiecesAreSymmetric());
  EXPECT_TRUE(linesOf(piece, LineKind::Fold).empty());
  ASSERT_EQ(piece.notes.size(), 1U);
  EXPECT_NE(piece.notes[0].text.find("not symmetric"), std::string::npos);
}

TEST(NamedFolds, OfAPieceThatHasItInsideAHalfIsDrawn)
{
  const PatternPiece piece = drawn(trapezium(0.0), onFold("centre"));
  expectFold(piece, 1e-9);
}

TEST(NamedFolds, APieceThatIsNotSymmetricIsRefusedWithTheCurveAndByHowMuch)
{
  // The corner is mirrored to 5 mm beside the other, along the upper side: so far from the slanting
  // side whose run is 50 to 300.
  const double miss = 5.0 * 300.0 / std::hypot(50.0, 300.0);
  EXPECT_NEAR(miss, 4.9, 0.05);
  expectRefusal(trapezium(5.0), onFold("centre"), { "front", "centre", "symmetric", "4.9 mm" });
}

TEST(NamedFolds, ACurveThatBendsOrIsSewnIsRefused)
{
  expectRefusal(trapezium(0.0, 2.0), onFold("centre"), { "front", "centre", "bends by 2 mm" });
  PatternSource sewn = trapezium(0.0);
  sewn.wires[1].type = WireType::Dart;
  expectRefusal(sewn, onFold("centre"), { "front", "centre", "sewn" });
  expectRefusal(trapezium(0.0), onFold("middle"), { "middle", "centre" });
}

TEST(NamedFolds, AHalfLiesWithItsEdgeOnTheFoldWithoutAllowance)
{
  const PatternPiece piece = drawn(halfOfIt(), onFold("centre"));
  const PatternPiece other = drawn(trapezium(0.0), onFold("centre"));
  EXPECT_NEAR(piece.extent.x(), other.extent.x(), 1e-3);
  expectFold(piece, 1e-3);
  // What lies on the fold is not sewn.
  EXPECT_EQ(lineOf(piece, LineKind::Internal).name, "centre");
}

TEST(NamedFolds, OnOneLayerOfClothThereIsAWholePieceOrNone)
{
  PatternOptions options = onFold("centre");
  options.oneLayer = true;
  EXPECT_GT(drawn(trapezium(0.0), options).extent.x(), 200.0);
  expectRefusal(halfOfIt(), options, { "front", "centre", "half" });
}
