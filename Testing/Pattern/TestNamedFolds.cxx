// SPDX-License-Identifier: BSD-3-Clause
// Folds along curves with names, on pieces whose numbers are known by construction.
#include "Drawing/PatternBuilder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace flattening;
using namespace flattening::pattern;

/// A trapezium of height 300 about x = 100 with its centre line. Unit: millimetre.
/// \param askew how far a corner is moved along the upper side
/// \param bend how far the middle of the centre line is moved across
PatternSource trapezium(double askew, double bend = 0.0)
{
  PatternSource source;
  source.positions = { { 0.0, 0.0 }, { 100.0, 0.0 }, { 200.0, 0.0 }, { 150.0 + askew, 300.0 },
    { 100.0, 300.0 }, { 50.0, 300.0 }, { 100.0 + bend, 150.0 } };
  source.triangles = { { 0, 1, 6 }, { 0, 6, 5 }, { 6, 4, 5 }, { 1, 2, 6 }, { 2, 3, 6 },
    { 3, 4, 6 } };
  source.pieceOfTriangle.assign(source.triangles.size(), 0);
  source.wires = { { { 0, 1, 2, 3, 4, 5, 0 }, WireType::Boundary, none, 0, "boundary" },
    { { 1, 6, 4 }, WireType::Key, 0, 0, "centre" } };
  return source;
}

/// Its right half, with the centre line on its border.
PatternSource halfOfIt()
{
  PatternSource source;
  source.positions = { { 100.0, 0.0 }, { 200.0, 0.0 }, { 150.0, 300.0 }, { 100.0, 300.0 } };
  source.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  source.pieceOfTriangle.assign(source.triangles.size(), 0);
  source.wires = { { { 0, 1, 2, 3 }, WireType::Boundary, none, 0, "boundary" },
    { { 3, 0 }, WireType::Accessory, 0, 0, "centre" } };
  return source;
}

PatternOptions onFold(const std::string& curve)
{
  PatternOptions options;
  options.fairTolerance = 0.0;
  options.notchSpacing = 100.0;
  options.unit = Unit::Millimetre;
  options.pieceNames = { "front" };
  options.foldsAlong = { curve };
  return options;
}

PatternPiece draw(const PatternSource& source, const PatternOptions& options)
{
  Pattern pattern;
  const Status status = buildPattern(source, options, pattern);
  EXPECT_TRUE(status.ok()) << status.message;
  return status.ok() ? pattern.pieces.at(0) : PatternPiece();
}

PatternLine lineOf(const PatternPiece& piece, LineKind kind)
{
  const auto found = std::find_if(piece.lines.begin(), piece.lines.end(),
    [kind](const PatternLine& line) { return line.kind == kind; });
  EXPECT_NE(found, piece.lines.end());
  return found == piece.lines.end() ? PatternLine() : *found;
}

bool says(const PatternPiece& piece, const std::string& words)
{
  return std::any_of(piece.texts.begin(), piece.texts.end(),
    [&words](const PatternText& text) { return text.text == words; });
}

void expectRefusal(
  const PatternSource& source, const PatternOptions& options, const std::vector<std::string>& words)
{
  Pattern pattern;
  const Status status = buildPattern(source, options, pattern);
  EXPECT_EQ(status.code, StatusCode::InvalidOption);
  for (const std::string& word : words)
  {
    EXPECT_NE(status.message.find(word), std::string::npos) << word << ": " << status.message;
  }
}
}

TEST(NamedFolds, OfAPieceThatHasItInsideAHalfIsDrawn)
{
  const PatternPiece piece = draw(trapezium(0.0), onFold("centre"));
  EXPECT_NEAR(piece.extent.y(), 320.0, 1e-3);
  const PatternLine fold = lineOf(piece, LineKind::Fold);
  for (const Point2& p : fold.points)
  {
    EXPECT_NEAR(p.x(), 0.0, 1e-9);
  }
  EXPECT_NEAR((fold.points[1] - fold.points[0]).norm(), 320.0, 1e-3);
  EXPECT_TRUE(says(piece, "cut 1 on fold"));
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
  const PatternPiece piece = draw(halfOfIt(), onFold("centre"));
  const PatternPiece other = draw(trapezium(0.0), onFold("centre"));
  EXPECT_NEAR(piece.extent.x(), other.extent.x(), 1e-3);
  EXPECT_NEAR(piece.extent.y(), 320.0, 1e-3);
  const PatternLine fold = lineOf(piece, LineKind::Fold);
  for (const Point2& p : fold.points)
  {
    EXPECT_NEAR(p.x(), 0.0, 1e-3);
  }
  EXPECT_NEAR((fold.points[1] - fold.points[0]).norm(), 320.0, 1e-3);
  EXPECT_TRUE(says(piece, "cut 1 on fold"));
  // What lies on the fold is not sewn.
  EXPECT_EQ(lineOf(piece, LineKind::Internal).name, "centre");
}

TEST(NamedFolds, OnOneLayerOfClothThereIsAWholePieceOrNone)
{
  PatternOptions options = onFold("centre");
  options.oneLayer = true;
  EXPECT_GT(draw(trapezium(0.0), options).extent.x(), 200.0);
  expectRefusal(halfOfIt(), options, { "front", "centre", "half" });
}
