// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CurveNames.h"
#include "Drawing/PatternStrokes.h"
#include "Outlines/PatternText.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace flattening::pattern;
using namespace shapes;

namespace
{
PatternLine makeLine(LineKind kind, const Points2& points, const std::string& name, bool closed)
{
  PatternLine line;
  line.kind = kind;
  line.points = points;
  line.name = name;
  line.closed = closed;
  return line;
}

/// A square of cloth with an upright line at x = 60, where a name on the level one would begin.
PatternPiece makeSquare(const Points2& level)
{
  PatternPiece piece;
  piece.lines.push_back(makeLine(LineKind::SewLine, rectangle(200.0, 200.0), "", true));
  piece.lines.push_back(
    makeLine(LineKind::Internal, { { 60.0, 0.0 }, { 60.0, 200.0 } }, "", false));
  piece.lines.push_back(makeLine(LineKind::Internal, level, "level line", false));
  return piece;
}

Segments boundaryOf(const PatternPiece& piece)
{
  return sidesOf(piece.lines.front().points);
}

/// Least distance of the middle line of a text from the lines of a piece.
double clearance(const PatternText& text, const PatternPiece& piece)
{
  Segments lines;
  for (const PatternLine& line : piece.lines)
  {
    addSegments(line.points, line.closed, lines);
  }
  const Point2 along(std::cos(text.angle), std::sin(text.angle));
  double least = 1e300;
  for (int k = -20; k <= 20; ++k)
  {
    const double place = k / 40.0 * textWidth(text.text, text.height);
    least = std::min(least, distance(text.position + place * along, lines));
  }
  return least;
}

/// Expects that all texts of a piece are apart by a rule.
template <class Rule>
void expectEachTwo(const PatternPiece& piece, const Rule& areApart)
{
  for (auto one = piece.texts.begin(); one != piece.texts.end(); ++one)
  {
    for (auto other = piece.texts.begin(); other != one; ++other)
    {
      EXPECT_TRUE(areApart(*one, *other)) << one->text << " on " << other->text;
    }
  }
}
}

TEST(CurveNames, ANameLiesBesideItsLineAndAcrossNoOther)
{
  PatternPiece piece = makeSquare({ { 0.0, 100.0 }, { 200.0, 100.0 } });
  placeCurveNames(boundaryOf(piece), piece);
  ASSERT_EQ(piece.texts.size(), 1U);
  const PatternText& text = piece.texts[0];
  EXPECT_NEAR(std::abs(text.position.y() - 100.0), text.height, 0.5 * text.height);
  EXPECT_GT(clearance(text, piece), 0.5 * text.height);
}

TEST(CurveNames, ANameKeepsOffItsOwnLineWhereThatIsBent)
{
  Points2 arc;
  for (int k = 0; k <= 40; ++k)
  {
    const double angle = 0.5 * pi * k / 40.0;
    arc.emplace_back(120.0 + 30.0 * std::cos(angle), 100.0 + 30.0 * std::sin(angle));
  }
  for (const bool turned : { false, true })
  {
    if (turned)
    {
      std::reverse(arc.begin(), arc.end());
    }
    PatternPiece piece = makeSquare(arc);
    placeCurveNames(boundaryOf(piece), piece);
    ASSERT_EQ(piece.texts.size(), 1U);
    EXPECT_GT(clearance(piece.texts[0], piece), 0.5 * piece.texts[0].height);
  }
}

TEST(CurveNames, TheNameOfASeamLiesOnTheCloth)
{
  for (const bool turned : { false, true })
  {
    PatternPiece piece = makeSquare({ { 100.0, 150.0 }, { 180.0, 150.0 } });
    PatternLine& seam = piece.lines[2];
    seam.kind = LineKind::SewLine;
    seam.points = { { 0.0, 0.0 }, { 0.0, 200.0 } };
    if (turned)
    {
      std::reverse(seam.points.begin(), seam.points.end());
    }
    placeCurveNames(boundaryOf(piece), piece);
    ASSERT_EQ(piece.texts.size(), 1U);
    EXPECT_GT(piece.texts[0].position.x(), 0.0);
  }
}

TEST(CurveNames, NamesKeepOffTheTitleAndOffEachOther)
{
  PatternPiece piece = makeSquare({ { 70.0, 100.0 }, { 190.0, 100.0 } });
  piece.lines.push_back(
    makeLine(LineKind::Internal, { { 70.0, 104.0 }, { 190.0, 104.0 } }, "next to it", false));
  PatternText title;
  title.text = "title";
  title.position = { 130.0, 98.0 };
  title.height = 3.0;
  piece.texts.push_back(title);
  placeCurveNames(boundaryOf(piece), piece);
  ASSERT_EQ(piece.texts.size(), 3U);
  expectEachTwo(piece, [](const PatternText& one, const PatternText& other) {
    const Point2 apart = (one.position - other.position).cwiseAbs();
    return apart.y() > 0.5 * (one.height + other.height) ||
      apart.x() > 0.5 * (textWidth(one.text, one.height) + textWidth(other.text, other.height));
  });
}

TEST(CurveNames, ALineTooShortForItsNameHasNone)
{
  PatternPiece piece = makeSquare({ { 100.0, 100.0 }, { 103.0, 100.0 } });
  placeCurveNames(boundaryOf(piece), piece);
  EXPECT_TRUE(piece.texts.empty());
}

TEST(CurveNames, ATitleIsCutWhereThePieceHasNoRoomForItAndOtherwiseWhole)
{
  const std::string ordinary(60, 'n');
  for (const std::string& name : { std::string("front"), ordinary, std::string(30000, 'n') })
  {
    PatternPiece piece = makeSquare({ { 20.0, 100.0 }, { 180.0, 100.0 } });
    PatternText title;
    title.text = name;
    piece.texts = { title };
    placeTexts(boundaryOf(piece), {}, piece);
    const std::string& written = piece.texts.front().text;
    EXPECT_EQ(written == name, name.size() <= ordinary.size());
    EXPECT_LT(written.size(), 400u);
    EXPECT_EQ(written.substr(0, 5), name.substr(0, 5));
  }
}

TEST(CurveNames, OfSmallPiecesLieOnNoOtherText)
{
  PatternPiece piece;
  const Points2 corners = regular(8, 20.0);
  std::vector<JoinSide> joins;
  piece.lines.push_back(makeLine(LineKind::CutLine, corners, "", true));
  const Segments boundary = boundaryOf(piece);
  for (std::size_t k = 0; k < 8; ++k)
  {
    const Points2 side{ corners[k], corners[(k + 1) % 8] };
    piece.lines.push_back(makeLine(LineKind::SewLine, side, "seam 1" + std::to_string(k), false));
    joins.push_back({ std::string(1, static_cast<char>('A' + k)), side });
  }
  piece.texts.push_back({});
  piece.texts.back().text = "piece 1 of 20";
  placeTexts(boundary, joins, piece);
  ASSERT_GE(piece.texts.size(), 9U); // its title and a mark on each side
  // Circles within the boxes of two texts.
  expectEachTwo(piece, [](const PatternText& one, const PatternText& other) {
    return (one.position - other.position).norm() > 0.5 * (one.height + other.height);
  });
}

TEST(PatternText, KeepsValidTextAndReplacesBrokenBytes)
{
  EXPECT_EQ(cleanText("Gr\xC3\xB6\xC3\x9F"
                      "e \xE8\xA3\xA4 \xF0\x9D\x94\x98"),
    "Gr\xC3\xB6\xC3\x9F"
    "e \xE8\xA3\xA4 \xF0\x9D\x94\x98");
  EXPECT_EQ(cleanText("a\xFFz"), "a\xEF\xBF\xBDz");
  EXPECT_EQ(cleanText("\xC3"), "\xEF\xBF\xBD");
  EXPECT_EQ(cleanText("\xC0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "overlong";
  EXPECT_EQ(cleanText("\xED\xA0\x80").find('\xED'), std::string::npos) << "surrogate";
  EXPECT_EQ(cleanText(std::string("a\0b\n\x7F"
                                  "c",
              6)),
    "a b  c");
}

TEST(PatternText, WritesNumbersWithoutExponentsAndTrailingZeros)
{
  EXPECT_EQ(formatNumber(1.5, 9), "1.5");
  EXPECT_EQ(formatNumber(-0.0, 9), "0");
  EXPECT_EQ(formatNumber(-1e-12, 9), "0");
  EXPECT_EQ(formatNumber(100.0, 3), "100");
  EXPECT_EQ(formatNumber(1e15, 3), "1000000000000000");
  EXPECT_EQ(formatNumber(1.0 / 3.0, 4), "0.3333");
}

TEST(PatternText, CutsLongTextsBetweenCharacters)
{
  EXPECT_EQ(fitText("short", 3.0, 100.0), "short");
  const std::string umlauts = "\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4";
  const std::string cut = fitText(umlauts, 3.0, textWidth("123456", 3.0) + 1e-9);
  EXPECT_EQ(cut, "\xC3\xA4\xC3\xA4\xC3\xA4...");
  EXPECT_EQ(fitText("no room", 3.0, 0.0), "...");
}

TEST(PatternText, CutsATextInTimeThatGrowsWithItsLengthAlone)
{
  const std::string letters(3000000, 'n'); // their square would take hours
  const std::string cut = fitText(letters, 3.0, textWidth(letters, 3.0) / 2.0);
  EXPECT_NEAR(static_cast<double>(cut.size()), 1500000.0, 1.0);
}
