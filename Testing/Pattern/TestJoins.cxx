// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SeamWalk.h"
#include "DrawnPieces.h"
#include "Formats/PatternFile.h"
#include "Outlines/Joins.h"
#include "Shapes.h"

namespace
{
using namespace drawnpieces;

/// A strip of 200 x 100 whose upper side is sewn to two squares of 100 beside each other: one
/// curve, two joins; the squares are sewn to each other as well. Unit: millimetre.
PatternSource stripAndSquares()
{
  PatternSource source;
  source.positions = { { 0.0, 0.0 }, { 200.0, 0.0 }, { 200.0, 100.0 }, { 100.0, 100.0 },
    { 0.0, 100.0 } };
  source.triangles = { { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 4 } };
  source.pieceOfTriangle.assign(3, 0);
  for (const double left : { 300.0, 500.0 })
  {
    const auto first = static_cast<Index>(source.positions.size());
    for (const Point2& p : { Point2(left, 0.0), Point2(left + 100.0, 0.0),
           Point2(left + 100.0, 100.0), Point2(left, 100.0) })
    {
      source.positions.push_back(p);
    }
    source.triangles.push_back({ first, first + 1, first + 2 });
    source.triangles.push_back({ first, first + 2, first + 3 });
    source.pieceOfTriangle.resize(source.triangles.size(), first == 5 ? 1 : 2);
  }
  source.wires = { { { 4, 3, 2 }, WireType::Seam, 0, 0, "yoke" },
    { { 5, 6 }, WireType::Seam, 0, 1, "yoke" }, { { 9, 10 }, WireType::Seam, 0, 2, "yoke" },
    { { 6, 7 }, WireType::Seam, 1, 1, "center" }, { { 9, 12 }, WireType::Seam, 1, 2, "center" },
    { { 4, 0, 1, 2 }, WireType::Boundary, none, 0, "boundary" },
    { { 7, 8, 5 }, WireType::Boundary, none, 1, "boundary" },
    { { 10, 11, 12 }, WireType::Boundary, none, 2, "boundary" } };
  source.sewn = { { { 4, 3 }, { 5, 6 } }, { { 3, 2 }, { 9, 10 } }, { { 6, 7 }, { 9, 12 } } };
  return source;
}

/// A file of a source; expects that it can be made. \param pattern gets what is drawn
std::string fileOf(const PatternSource& source, const FileOptions& options, Pattern& pattern)
{
  std::string content;
  const Status status = makePatternFile(source, options, pattern, content);
  EXPECT_TRUE(status.ok()) << status.message;
  return content;
}

/// How often each mark is on a piece.
std::map<std::string, int> marksOf(const PatternPiece& piece)
{
  std::map<std::string, int> marks;
  for (const PatternText& text : piece.texts)
  {
    marks[text.text] += text.role == TextRole::Join ? 1 : 0;
  }
  for (auto mark = marks.begin(); mark != marks.end();)
  {
    mark = mark->second == 0 ? marks.erase(mark) : std::next(mark);
  }
  return marks;
}

/// The left square hangs down from the strip, the right one rises by 60 degrees.
PatternSource bentStripAndSquares()
{
  PatternSource source = stripAndSquares();
  const double half = 50.0 * std::sqrt(3.0);
  source.inSpace = { { 0.0, 0.0, 0.0 }, { 200.0, 0.0, 0.0 }, { 200.0, 100.0, 0.0 },
    { 100.0, 100.0, 0.0 }, { 0.0, 100.0, 0.0 }, { 0.0, 100.0, 0.0 }, { 100.0, 100.0, 0.0 },
    { 100.0, 100.0, -100.0 }, { 0.0, 100.0, -100.0 }, { 100.0, 100.0, 0.0 }, { 200.0, 100.0, 0.0 },
    { 200.0, 150.0, half }, { 100.0, 150.0, half } };
  return source;
}
}

TEST(Joins, MarksCountOnBehindZ)
{
  EXPECT_EQ(joinMark(0), "A");
  EXPECT_EQ(joinMark(7), "H");
  EXPECT_EQ(joinMark(8), "J"); // an I would look like a notch
  EXPECT_EQ(joinMark(23), "Z");
  EXPECT_EQ(joinMark(24), "AA");
  EXPECT_EQ(joinMark(25), "AB");
  EXPECT_EQ(joinMark(24 * 25), "AAA");
}

TEST(Joins, ACurveThatMeetsTwoPiecesIsTwoJoinsWithMarksOnBothSides)
{
  const Pattern pattern = patternOf(stripAndSquares(), inMillimetres());
  ASSERT_EQ(pattern.pieces.size(), 3U);
  using Marks = std::map<std::string, int>;
  EXPECT_EQ(marksOf(pattern.pieces[0]), (Marks{ { "A", 3 }, { "B", 3 } }));
  EXPECT_EQ(marksOf(pattern.pieces[1]), (Marks{ { "A", 3 }, { "C", 3 } }));
  EXPECT_EQ(marksOf(pattern.pieces[2]), (Marks{ { "B", 3 }, { "C", 3 } }));
  // Along the upper side of the strip, within the cloth, which begins 10 mm inside its allowance.
  for (const PatternText& text : pattern.pieces[0].texts)
  {
    if (text.role == TextRole::Join)
    {
      EXPECT_EQ(text.position.x() < 110.0, text.text == "A");
      EXPECT_LT(text.position.y(), 110.0);
      EXPECT_GT(text.position.y(), 95.0);
    }
  }
  PatternSource tiny = stripAndSquares();
  for (Point2& position : tiny.positions)
  {
    position *= 0.15; // joins of 15 mm
  }
  EXPECT_EQ(marksOf(patternOf(tiny, inMillimetres()).pieces[0]), (Marks{ { "A", 3 }, { "B", 3 } }));
}

TEST(Joins, EachHasANotchOfItsOwnThatTellsItsEndsApart)
{
  PatternOptions options = inMillimetres();
  options.notchSpacing = 250.0; // longer than the curve
  const Pattern pattern = patternOf(stripAndSquares(), options);
  std::vector<double> places;
  for (const Notch& notch : pattern.pieces[0].notches)
  {
    places.push_back(notch.foot.x() - 10.0);
  }
  std::sort(places.begin(), places.end());
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0], 40.0, 1e-9);
  EXPECT_NEAR(places[1], 140.0, 1e-9);
}

TEST(Joins, APieceForItsMirrorImageAsWellHasTheMarksOfBoth)
{
  PatternSource source = stripAndSquares();
  // The squares become mirror images without an axis of their own, of sides of different lengths.
  source.positions[7] = { 430.0, 80.0 };
  source.positions[12] = { 470.0, 80.0 };
  PatternOptions options = inMillimetres();
  options.pairs = true;
  const Pattern pattern = patternOf(source, options);
  ASSERT_EQ(pattern.pieces.size(), 2U);
  using Marks = std::map<std::string, int>;
  EXPECT_EQ(marksOf(pattern.pieces[0]), (Marks{ { "A", 3 }, { "B", 3 } }));
  EXPECT_EQ(marksOf(pattern.pieces[1]), (Marks{ { "A/B", 3 }, { "C", 3 } }));
}

TEST(Joins, TheTableHasTheirPiecesAndLengths)
{
  const PatternSource source = stripAndSquares();
  FileOptions options;
  options.format = FileFormat::Pdf;
  options.pattern = inMillimetres();
  options.pattern.pieceNames = { "strip", "left", "right" };
  Pattern pattern;
  fileOf(source, options, pattern);
  ASSERT_EQ(pattern.tables.size(), 1U);
  const std::vector<std::vector<std::string>>& rows = pattern.tables.front().rows;
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(
    rows[1], (std::vector<std::string>{ "A", "yoke", "1: strip", "2: left", "100", "100", "" }));
  EXPECT_EQ(
    rows[2], (std::vector<std::string>{ "B", "yoke", "1: strip", "3: right", "100", "100", "" }));
  EXPECT_EQ(
    rows[3], (std::vector<std::string>{ "C", "center", "2: left", "3: right", "100", "100", "" }));
  options.pages.paper = PaperSize::Sheet;
  fileOf(source, options, pattern);
  EXPECT_TRUE(pattern.tables.empty());
}

TEST(Joins, TheirBendIsThatOfTheSurface)
{
  const PatternSource source = bentStripAndSquares();
  std::vector<WalkInterval> walk;
  ASSERT_TRUE(drawnpieces::walk(source, inMillimetres(), walk).ok());
  EXPECT_EQ(walk.front().join, "A");
  EXPECT_NEAR(walk.front().bend, pi / 2.0, 1e-12);
  EXPECT_EQ(walk.at(2).join, "B");
  EXPECT_NEAR(walk.at(2).bend, -pi / 3.0, 1e-12);
}

TEST(Joins, ThickMaterialIsBeveledByHalfOfTheBend)
{
  const PatternSource source = bentStripAndSquares();
  FileOptions options;
  options.format = FileFormat::Pdf;
  options.pattern = inMillimetres();
  options.pattern.thickness = 12.0;
  Pattern pattern;
  fileOf(source, options, pattern);
  const std::vector<std::vector<std::string>>& rows = pattern.tables.at(0).rows;
  EXPECT_EQ(rows.at(0).back(), "Bevel");
  EXPECT_EQ(rows.at(1).back(), "45\u00b0, 12 mm");
  EXPECT_EQ(rows.at(2).back(), "-30\u00b0, -6.9 mm"); // 12 tan 30 degrees
  options.format = FileFormat::Walk;
  const std::string content = fileOf(source, options, pattern);
  EXPECT_NE(content.find("bend_deg,bevel_deg,bevel_mm\n"), std::string::npos);
  EXPECT_NE(content.find(",A,90,45,12\n"), std::string::npos);
}

TEST(Joins, TabsToGlueAreOnTheFirstSideOfEach)
{
  PatternOptions options = inMillimetres(0.0);
  options.glueTab = 15.0;
  const Pattern pattern = patternOf(stripAndSquares(), options);
  const double tab = (100.0 + 70.0) / 2.0 * 15.0; // its ends are cut off at 45 degrees
  const std::vector<double> areas{ 20000.0 + 2.0 * tab, 10000.0 + tab, 10000.0 };
  for (std::size_t p = 0; p < 3; ++p)
  {
    EXPECT_NEAR(areaOf(lineOf(pattern.pieces[p], LineKind::CutLine).points), areas[p], 1e-2);
  }
}

TEST(Joins, NoneIsDrawnWhereTheyAreTurnedOff)
{
  PatternOptions options = inMillimetres();
  options.joinMarks = false;
  for (const PatternPiece& piece : patternOf(stripAndSquares(), options).pieces)
  {
    EXPECT_TRUE(marksOf(piece).empty());
  }
}

TEST(Joins, OneSideOfASeamHasAnAllowanceOfItsOwn)
{
  PatternOptions options = inMillimetres(0.0);
  options.allowanceOfCurve = { { "yoke", 4.0 }, { "yoke:2", 25.0 }, { "boundary:3", 10.0 } };
  const Pattern pattern = patternOf(stripAndSquares(), options);
  const auto areaOfCloth = [&pattern](std::size_t piece) {
    return areaOf(lineOf(pattern.pieces.at(piece), LineKind::CutLine).points);
  };
  EXPECT_NEAR(areaOfCloth(0), 200.0 * 104.0, 1e-3); // both joins of the other side
  EXPECT_NEAR(areaOfCloth(1), 100.0 * 125.0, 1e-3);
  EXPECT_NEAR(areaOfCloth(2), 100.0 * 114.0 + 110.0 * 10.0 + 4.0 * 10.0, 60.0);
  options.allowanceOfCurve = { { "yoke:4", 4.0 } };
  expectRefusal(stripAndSquares(), options, { "yoke:4", "not there" });
}

TEST(Joins, ALaserFollowsARoundByFewArcs)
{
  // A disc of 200 edges, whose cut line is one of 10 mm more.
  PatternSource source;
  source.positions = shapes::regular(200, 90.0, Point2(100.0, 100.0));
  source.positions.insert(source.positions.begin(), Point2(100.0, 100.0));
  for (int k = 0; k < 200; ++k)
  {
    source.triangles.push_back({ 0, 1 + k, 1 + (k + 1) % 200 });
  }
  source.pieceOfTriangle.assign(200, 0);
  FileOptions options;
  options.laserColors = true;
  options.pattern = inMillimetres();
  Pattern pattern;
  const std::string content = fileOf(source, options, pattern);
  const std::size_t cut = content.find("class=\"cut-line\"");
  ASSERT_NE(cut, std::string::npos);
  const std::size_t from = content.find(" d=\"", cut) + 4;
  const std::string path = content.substr(from, content.find('"', from) - from);
  // About the center the way is counter-clockwise, which SVG, whose y points down, calls 0.
  std::size_t arcs = 0;
  for (std::size_t at = path.find('A'); at != std::string::npos; at = path.find('A', at + 1))
  {
    ++arcs;
    EXPECT_NEAR(std::stod(path.substr(at + 1)), 100.0, 0.1);
    EXPECT_NE(path.find(" 0 0 0 ", at), std::string::npos);
  }
  EXPECT_GE(arcs, 2U);
  EXPECT_LE(arcs, 5U);
  EXPECT_EQ(path.find('L'), std::string::npos);
}

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
