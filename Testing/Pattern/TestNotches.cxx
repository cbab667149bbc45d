// SPDX-License-Identifier: BSD-3-Clause
#include "PatternBuilder.h"

#include <gtest/gtest.h>

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

Status build(const std::map<std::string, std::vector<double>>& notches, Pattern& pattern)
{
  PatternOptions options;
  options.unit = Unit::Millimetre;
  options.notchesOfCurve = notches;
  options.allowanceOfCurve = { { "hem", 40.0 } };
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
