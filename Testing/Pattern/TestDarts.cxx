// SPDX-License-Identifier: BSD-3-Clause
// Strips and squares with one dart, whose numbers are known by construction.
#include "DrawnPieces.h"

namespace
{
using namespace drawnpieces;

/// The square with legs that bend, mirror images of each other.
PatternSource bentDart()
{
  PatternSource source = dartedSquare();
  source.positions.emplace_back(113.0, 140.0);
  source.positions.emplace_back(87.0, 140.0);
  source.triangles = { { 0, 1, 7 }, { 1, 2, 5 }, { 2, 4, 8 }, { 2, 8, 5 }, { 6, 3, 9 }, { 9, 3, 5 },
    { 3, 0, 5 }, { 1, 5, 7 }, { 5, 0, 7 } };
  source.pieceOfTriangle.assign(source.triangles.size(), 0);
  source.wires[1].points = { 4, 8, 5 };
  source.wires[2].points = { 6, 9, 5 };
  source.sewn = { { { 4, 8 }, { 6, 9 } }, { { 8, 5 }, { 9, 5 } } };
  return source;
}

}

TEST(Darts, AFoldedDartIsClosedByTheMirrorImageOfItsNeighbour)
{
  const PatternPiece piece = drawn(dartedSquare(), inMillimetres(0.0));
  // The mirror image of the upper side across a leg meets the fold line at 120 + 2 x 20 x (20 /
  // 120) / (1 - (20 / 120)^2) above the tip: by hand, tip + t (0, 1) with t = 120 + 20 tan(2
  // atan(20 / 120)).
  const double height = 120.0 + 20.0 * std::tan(2.0 * std::atan2(20.0, 120.0));
  EXPECT_NEAR(piece.extent.y(), 80.0 + height, 1e-9);
  EXPECT_NEAR(areaOf(lineOf(piece, LineKind::CutLine).points),
    200.0 * 200.0 + 0.5 * 40.0 * (height - 120.0), 1e-6);
}

TEST(Darts, LegsFoldLineNotchesAndDrillHoleAreWhereTheyBelong)
{
  const PatternPiece piece = drawn(dartedSquare(), inMillimetres(10.0));
  const auto legs = linesOf(piece, LineKind::DartLeg);
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_NEAR(legs[0].restLength, std::hypot(20.0, 120.0), 1e-9);
  const auto fold = linesOf(piece, LineKind::DartFold);
  ASSERT_EQ(fold.size(), 1U);
  EXPECT_NEAR(fold[0].points[0].x(), fold[0].points[1].x(), 1e-9);
  EXPECT_EQ(fold[0].points[0], legs[0].points.back());
  ASSERT_EQ(piece.drillHoles.size(), 1U);
  EXPECT_NEAR((piece.drillHoles[0] - fold[0].points[0]).norm(), 10.0, 1e-9);
  // One at the end of each leg, and one in the middle of each, which is shorter than the spacing.
  const auto onCut = [](const Notch& notch) { return notch.onCutLine; };
  EXPECT_EQ(std::count_if(piece.notches.begin(), piece.notches.end(), onCut), 2);
  EXPECT_EQ(piece.notches.size(), 4U);
  for (const Notch& notch : piece.notches)
  {
    const double share = notch.onCutLine ? 1.0 : 0.5;
    EXPECT_NEAR((notch.foot - fold[0].points[0]).norm(), share * std::hypot(20.0, 120.0), 1e-9);
  }
}

TEST(Darts, TheFoldLineOfADartFromAHoleEndsAtItsMouth)
{
  // A square with a hole, whose upper sides from 5 and 7 to the tip 6 are the legs.
  const PatternSource source =
    onePiece({ { 0.0, 0.0 }, { 200.0, 0.0 }, { 200.0, 200.0 }, { 0.0, 200.0 }, { 100.0, 60.0 },
               { 110.0, 100.0 }, { 100.0, 150.0 }, { 90.0, 100.0 } },
      { { 0, 1, 4 }, { 1, 5, 4 }, { 1, 2, 5 }, { 2, 6, 5 }, { 2, 3, 6 }, { 3, 7, 6 }, { 3, 0, 7 },
        { 0, 4, 7 } },
      { { { 0, 1, 2, 3, 0 }, WireType::Boundary, none, 0, "boundary" },
        { { 7, 4, 5 }, WireType::Boundary, none, 0, "boundary" },
        { { 5, 6 }, WireType::Dart, 0, 0, "dart" }, { { 7, 6 }, WireType::Dart, 0, 0, "dart" } },
      { { { 5, 6 }, { 7, 6 } } });
  const auto fold = linesOf(drawn(source, inMillimetres(10.0)), LineKind::DartFold);
  ASSERT_EQ(fold.size(), 1U);
  EXPECT_NEAR((fold[0].points[1] - fold[0].points[0]).norm(), 50.0, 1e-9);
}

TEST(Darts, ATipIsDrawnBackWithLegsRoofAndDrillHole)
{
  PatternOptions options = inMillimetres(0.0);
  options.dartTip = 13.0;
  const PatternPiece piece = drawn(dartedSquare(), options);
  const auto legs = linesOf(piece, LineKind::DartLeg);
  ASSERT_EQ(legs.size(), 2U);
  for (const PatternLine& leg : legs)
  {
    EXPECT_NEAR(leg.restLength, std::hypot(20.0, 107.0), 1e-9);
    EXPECT_NEAR((leg.points.back() - leg.points.front()).norm(), std::hypot(20.0, 107.0), 1e-9);
    EXPECT_NEAR(leg.points.back().y(), 93.0, 1e-9);
  }
  EXPECT_NEAR((legs[0].points.front() - legs[1].points.front()).norm(), 40.0, 1e-9);
  ASSERT_EQ(piece.drillHoles.size(), 1U);
  EXPECT_NEAR(piece.drillHoles[0].y(), 103.0, 1e-9);
  // As of a dart of that depth.
  EXPECT_NEAR(piece.extent.y(), 200.0 + 20.0 * std::tan(2.0 * std::atan2(20.0, 107.0)), 1e-9);
}

TEST(Darts, BentLegsThatAreMirrorImagesStaySoWhenTheTipIsDrawnBack)
{
  PatternOptions options = inMillimetres(10.0);
  options.dartTip = 50.0;
  options.dartTipOfCurve = { { "dart", 30.0 } };
  const PatternPiece piece = drawn(bentDart(), options);
  const auto legs = linesOf(piece, LineKind::DartLeg);
  ASSERT_EQ(legs.size(), 2U);
  const double middle = linesOf(piece, LineKind::DartFold)[0].points[0].x();
  ASSERT_EQ(legs[0].points.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(legs[0].points[k].x() - middle, middle - legs[1].points[k].x(), 1e-9);
    EXPECT_NEAR(legs[0].points[k].y(), legs[1].points[k].y(), 1e-9);
  }
  EXPECT_NEAR(legs[0].restLength, legs[1].restLength, 1e-9);
  // Half way in, half as far.
  EXPECT_NEAR(legs[0].points[0].y() - legs[0].points[1].y(), 60.0 * 90.0 / 120.0, 1e-9);
  EXPECT_NEAR(legs[0].points[0].y() - legs[0].points[2].y(), 90.0, 1e-9);
  std::vector<Notch> across;
  std::copy_if(piece.notches.begin(), piece.notches.end(), std::back_inserter(across),
    [](const Notch& notch) { return !notch.onCutLine; });
  ASSERT_EQ(across.size(), 2U);
  EXPECT_NEAR(across[0].foot.x() - middle, middle - across[1].foot.x(), 1e-9);
  EXPECT_NEAR(across[0].foot.y(), across[1].foot.y(), 1e-9);
}

TEST(Darts, ATipThatWouldBeBeyondHalfOfItsDartIsRefusedByName)
{
  PatternOptions options = inMillimetres(10.0);
  options.pieceNames = { "front" };
  options.dartTip = 61.0;
  expectRefusal(dartedSquare(), options, { "dart dart", "front", "61 mm", "120 mm" });
  options.dartTip = 59.0;
  drawn(dartedSquare(), options);
}

TEST(Darts, ADartThatIsCutOutHasAllowanceAlongItsLegs)
{
  PatternOptions options = inMillimetres(10.0);
  options.cutDartsOut = true;
  const PatternPiece piece = drawn(dartedSquare(), options);
  EXPECT_TRUE(linesOf(piece, LineKind::DartLeg).empty());
  EXPECT_TRUE(linesOf(piece, LineKind::DartFold).empty());
  EXPECT_TRUE(piece.drillHoles.empty());
  const double closed =
    areaOf(linesOf(drawn(dartedSquare(), inMillimetres(10.0)), LineKind::CutLine)[0].points);
  EXPECT_LT(areaOf(linesOf(piece, LineKind::CutLine)[0].points), closed - 500.0);
}

TEST(Darts, LegsThatAreNotPartnersAreNotFolded)
{
  PatternSource source = dartedSquare();
  source.sewn.clear();
  const PatternPiece piece = drawn(source, inMillimetres(10.0));
  EXPECT_TRUE(linesOf(piece, LineKind::DartLeg).empty());
}

// What else is no pattern: IO/Testing/Cxx/TestPatternWriterRefusals.
TEST(PatternBuilder, RefusesWhatIsNoPattern)
{
  const auto codeOf = [](const std::function<void(PatternSource&, PatternOptions&)>& spoil) {
    PatternSource source = dartedSquare();
    PatternOptions options = inMillimetres(10.0);
    spoil(source, options);
    Pattern pattern;
    const Status status = drawnpieces::draw(source, options, pattern);
    EXPECT_EQ(status.ok(), status.message.empty());
    return status.code;
  };
  EXPECT_EQ(codeOf([](auto& source, auto&) { source.positions[3].x() = std::nan(""); }),
    StatusCode::InvalidPattern);
  EXPECT_EQ(codeOf([](auto& source, auto&) {
    for (Point2& p : source.positions)
    {
      p.y() = 0.0;
    }
  }),
    StatusCode::NothingToDraw);
  EXPECT_EQ(codeOf([](auto& source, auto&) { source.pieceOfTriangle[0] = 2; }),
    StatusCode::NothingToDraw); // piece 1 is empty
  EXPECT_EQ(codeOf([](auto& source, auto&) { source.pieceOfTriangle[0] = -1; }),
    StatusCode::InvalidPattern);
  EXPECT_EQ(codeOf([](auto&, auto& options) { options.symmetrize = true; }),
    StatusCode::InvalidOption); // of borders that are not smooth
}

TEST(Darts, LegsThatMissEachOtherAreNoted)
{
  PatternSource source = bentDart();
  const auto says = [](const PatternPiece& piece) {
    return std::any_of(piece.notes.begin(), piece.notes.end(), [](const PatternNote& note) {
      return note.text.find("the legs of dart miss each other by up to 5 mm") != std::string::npos;
    });
  };
  EXPECT_FALSE(says(drawn(source, inMillimetres())));
  source.positions[9] += Point2(3.0, 4.0);
  EXPECT_TRUE(says(drawn(source, inMillimetres())));
}

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
