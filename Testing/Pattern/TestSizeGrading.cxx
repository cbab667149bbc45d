// SPDX-License-Identifier: BSD-3-Clause
// Sizes of rectangles, whose corners go by half of what their sides differ.
#include "Grading/GradeFiles.h"

#include "Shapes.h"

#include <cstdio>
#include <limits>

namespace
{
using namespace flattening;
using namespace flattening::pattern;

std::size_t countOf(const std::string& text, const std::string& what)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
  {
    ++count;
  }
  return count;
}

/// A rectangle in two triangles, turned by an angle and put elsewhere.
PatternSize rectangle(const std::string& name, double width, double height, double turn = 0.0)
{
  PatternSize size;
  size.name = name;
  for (const Point2& p : shapes::rectangle(width, height))
  {
    size.source.positions.emplace_back(3.0 + std::cos(turn) * p.x() - std::sin(turn) * p.y(),
      -7.0 + std::sin(turn) * p.x() + std::cos(turn) * p.y());
  }
  size.source.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  size.source.pieceOfTriangle = { 0, 0 };
  size.source.wires = { { { 0, 1, 2, 3, 0 }, WireType::Boundary, none, 0, "boundary" } };
  return size;
}
}

TEST(SizeGrading, CornersGoByHalfOfWhatSidesDiffer)
{
  Grading grading;
  ASSERT_TRUE(gradeSizes(
    { rectangle("S", 40.0, 60.0), rectangle("M", 42.0, 63.0), rectangle("L", 46.0, 65.0) }, {},
    grading)
                .ok());
  EXPECT_EQ(grading.base, 1U);
  ASSERT_EQ(grading.rules.size(), 4U);
  for (const GradeRule& rule : grading.rules)
  {
    EXPECT_EQ(rule.name, "boundary");
    const Point2 sides(
      rule.point == 1 || rule.point == 2 ? 1.0 : -1.0, rule.point > 1 ? 1.0 : -1.0);
    const Points2 wanted{ { -10.0, -15.0 }, { 0.0, 0.0 }, { 20.0, 10.0 } };
    for (std::size_t s = 0; s < 3; ++s)
    {
      EXPECT_NEAR((rule.deltas[s] - sides.cwiseProduct(wanted[s])).norm(), 0.0, 1e-12);
    }
  }
  EXPECT_EQ(countOf(makeNest(grading, "nest"), "<path "), 3U);
  EXPECT_EQ(countOf(makeRuleList(grading), "\n"), 5U);
}

TEST(SizeGrading, RulesOfTheTableGoAlongTheAxesOfTheDrawing)
{
  GradingOptions options;
  options.unit = Unit::Inch;
  options.base = "1 x";
  options.alignment = "grain";
  const double turn = 0.4;
  std::vector<PatternSize> sizes{ rectangle("1 x", 4.0, 6.0, turn),
    rectangle("2", 6.0, 6.0, turn) };
  for (PatternSize& size : sizes)
  {
    size.source.wires.push_back({ { 0, 3 }, WireType::Key, 0, 0, "grain" });
  }
  Grading grading;
  ASSERT_TRUE(gradeSizes(sizes, options, grading).ok());
  // Laid on each other at the first corner and along the side, the other one goes by 2 inches.
  EXPECT_NEAR((grading.rules[1].deltas[1] - Point2(50.8, 0.0)).norm(), 0.0, 1e-10);
  const std::string table = makeRuleTable(grading, "table", options.unit, "2026-01-02", "03:04");
  EXPECT_NE(table.find("UNITS: ENGLISH\n"), std::string::npos);
  EXPECT_NE(table.find("SIZE LIST: 1_x 2\nSAMPLE SIZE: 1_x\n"), std::string::npos);
  const std::size_t rule = table.find("RULE: DELTA 2\n  0.000000, 0.000000\n");
  ASSERT_NE(rule, std::string::npos) << table;
  double x = 0.0;
  double y = 0.0;
  ASSERT_EQ(
    std::sscanf(table.c_str() + table.find('\n', table.find('\n', rule) + 1), "%lf, %lf", &x, &y),
    2);
  EXPECT_NEAR(x, 2.0 * std::cos(turn), 1e-6);
  EXPECT_NEAR(y, 2.0 * std::sin(turn), 1e-6);
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
