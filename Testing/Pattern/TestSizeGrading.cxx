// SPDX-License-Identifier: BSD-3-Clause
// Broken sizes, and names with blanks.
#include "Grading/GradeFiles.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace flattening;
using namespace flattening::pattern;

/// A rectangle in two triangles.
PatternSize rectangle(const std::string& name, double width, double height)
{
  PatternSize size;
  size.name = name;
  size.source.positions = shapes::rectangle(width, height);
  size.source.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  size.source.pieceOfTriangle = { 0, 0 };
  size.source.wires = { { { 0, 1, 2, 3, 0 }, WireType::Boundary, none, 0, "boundary" } };
  return size;
}
}

TEST(SizeGrading, NamesInTheRuleTableHaveNoBlanks)
{
  GradingOptions options;
  options.base = "1 x";
  Grading grading;
  ASSERT_TRUE(
    gradeSizes({ rectangle("1 x", 4.0, 6.0), rectangle("2", 6.0, 6.0) }, options, grading).ok());
  const std::string table = makeRuleTable(grading, "table", options.unit, "2026-01-02", "03:04");
  EXPECT_NE(table.find("SIZE LIST: 1_x 2\nSAMPLE SIZE: 1_x\n"), std::string::npos);
}

TEST(SizeGrading, BrokenSizesAreRefusedByName)
{
  const PatternSize good = rectangle("M", 1.0, 2.0);
  PatternSize infinite = rectangle("L", 2.0, 2.0);
  infinite.source.positions[2].x() = std::numeric_limits<double>::infinity();
  PatternSize homeless = good;
  homeless.source.wires[0].piece = none;
  PatternSize other = rectangle("L", 2.0, 2.0);
  other.source.triangles = { { 0, 1, 3 }, { 1, 2, 3 } };
  Grading grading;
  for (const auto& [sizes, code] : std::vector<std::pair<std::vector<PatternSize>, StatusCode>>{
         { { good, infinite }, StatusCode::InvalidPattern },
         { { homeless, homeless }, StatusCode::InvalidOption }, // two of one name
         { { good, other }, StatusCode::InvalidOption }, { { good }, StatusCode::InvalidOption } })
  {
    const Status status = gradeSizes(sizes, {}, grading);
    EXPECT_EQ(status.code, code);
    EXPECT_TRUE(grading.positions.empty());
  }
  PatternSize second = homeless;
  second.name = "L";
  EXPECT_EQ(gradeSizes({ homeless, second }, {}, grading).code, StatusCode::InvalidPattern);
}
