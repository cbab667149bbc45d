// SPDX-License-Identifier: BSD-3-Clause
// Halves of shapes whose axis and lengths are known by construction.
#include "Drawing/HalfPiece.h"
#include "Drawing/PatternBuilder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace flattening;
using namespace flattening::pattern;

/// A kite about the line through the origin at an angle: its area is 30 * 40, half of it on each
/// side.
Points2 kite(double angle)
{
  const Point2 along(std::cos(angle), std::sin(angle));
  const Point2 left(-along.y(), along.x());
  return { -10.0 * along, 20.0 * along - 30.0 * left, 30.0 * along, 20.0 * along + 30.0 * left };
}

double areaOf(const Points2& polygon)
{
  double area = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const Point2& a = polygon[k];
    const Point2& b = polygon[(k + 1) % polygon.size()];
    area += (a.x() * b.y() - a.y() * b.x()) / 2.0;
  }
  return area;
}

/// A trapezium, upright and symmetric about x = 100, with a line across it. Unit: millimetre.
PatternSource trapezium(double askew)
{
  PatternSource source;
  source.positions = { { 0.0, 0.0 }, { 200.0, 0.0 }, { 150.0 + askew, 300.0 }, { 50.0, 300.0 },
    { 20.0, 120.0 }, { 180.0, 120.0 } };
  source.triangles = { { 0, 1, 5 }, { 0, 5, 4 }, { 4, 5, 2 }, { 4, 2, 3 } };
  source.pieceOfTriangle.assign(source.triangles.size(), 0);
  source.wires = { { { 0, 1, 5, 2, 3, 4, 0 }, WireType::Boundary, none, 0, "boundary" },
    { { 4, 5 }, WireType::Accessory, 0, 0, "waist" } };
  return source;
}

PatternPiece drawn(const PatternSource& source)
{
  PatternOptions options;
  options.fairTolerance = 0.0;
  options.notchSpacing = 100.0;
  options.unit = Unit::Millimetre;
  options.cutOnFold = true;
  Pattern pattern;
  const Status status = buildPattern(source, options, pattern);
  EXPECT_TRUE(status.ok()) << status.message;
  return pattern.pieces.at(0);
}

const PatternLine* lineOf(const PatternPiece& piece, LineKind kind)
{
  for (const PatternLine& line : piece.lines)
  {
    if (line.kind == kind)
    {
      return &line;
    }
  }
  return nullptr;
}
}

TEST(HalfPiece, TheAxisOfASymmetricShapeIsFoundHoweverItIsTurned)
{
  for (const double angle : { 0.3, 1.2, 2.0 })
  {
    const std::optional<MirrorAxis> axis = findMirrorAxis({ kite(angle), {} }, 0.5);
    ASSERT_TRUE(axis.has_value());
    const double expected = std::abs(axis->along.dot(Point2(std::cos(angle), std::sin(angle))));
    EXPECT_NEAR(expected, 1.0, 1e-9);
    EXPECT_NEAR(axis->miss, 0.0, 1e-9);
    EXPECT_NEAR(areaOf(rightHalf(kite(angle), *axis)), areaOf(kite(angle)) / 2.0, 1e-9);
  }
}

TEST(HalfPiece, AShapeThatIsNotSymmetricHasNoAxis)
{
  Points2 shape = kite(0.4);
  shape[1] *= 1.1;
  EXPECT_FALSE(findMirrorAxis({ shape, {} }, 0.5).has_value());
}

TEST(HalfPiece, LinesThatRunAcrossTheFoldAreHalved)
{
  const PatternPiece piece = drawn(trapezium(0.0));
  const PatternLine* const waist = lineOf(piece, LineKind::Internal);
  ASSERT_NE(waist, nullptr);
  EXPECT_NEAR((waist->points.back() - waist->points.front()).norm(), 80.0, 1e-9);
  EXPECT_NEAR(waist->restLength, 80.0, 1e-9);
  const PatternLine* const fold = lineOf(piece, LineKind::Fold);
  ASSERT_NE(fold, nullptr);
  // With an allowance of 10 mm at both ends.
  EXPECT_NEAR((fold->points.back() - fold->points.front()).norm(), 320.0, 1e-3);
  EXPECT_NEAR(fold->points.front().x(), fold->points.back().x(), 1e-9);
  const PatternLine* const sew = lineOf(piece, LineKind::SewLine);
  ASSERT_NE(sew, nullptr);
  EXPECT_FALSE(sew->closed);
  EXPECT_NEAR(sew->restLength, 100.0 + std::hypot(50.0, 300.0) + 50.0, 0.2);
}

TEST(HalfPiece, TheCutLineAndItsMirrorImageAreTheWholePiece)
{
  PatternSource source = trapezium(0.0);
  const double half = areaOf(lineOf(drawn(source), LineKind::CutLine)->points);
  PatternOptions options;
  options.fairTolerance = 0.0;
  options.notchSpacing = 100.0;
  options.unit = Unit::Millimetre;
  Pattern whole;
  ASSERT_TRUE(buildPattern(source, options, whole).ok());
  EXPECT_NEAR(2.0 * half, areaOf(lineOf(whole.pieces[0], LineKind::CutLine)->points), 0.5);
}

TEST(HalfPiece, APieceSaysThatItIsCutOnTheFold)
{
  const PatternPiece piece = drawn(trapezium(0.0));
  bool said = false;
  for (const PatternText& text : piece.texts)
  {
    said = said || text.text == "cut 1 on fold";
  }
  EXPECT_TRUE(said);
}

TEST(HalfPiece, APieceThatIsNotSymmetricIsDrawnWholeAndSaysSo)
{
  const PatternPiece piece = drawn(trapezium(5.0));
  EXPECT_EQ(lineOf(piece, LineKind::Fold), nullptr);
  ASSERT_EQ(piece.notes.size(), 1U);
  EXPECT_NE(piece.notes[0].text.find("not symmetric"), std::string::npos);
}
