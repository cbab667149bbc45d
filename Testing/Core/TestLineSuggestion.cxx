// SPDX-License-Identifier: BSD-3-Clause
#include "Design/LineSuggestion.h"

#include "SuggestionTesting.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Half of a vase round z, narrowest at z = 0.5 and widest at z = 2.
TriangleMesh vase()
{
  return patch(24, 36, [](double i, double j) {
    const double turn = pi * i / 24.0;
    const double z = 3.5 * j / 36.0 - 1.0 / 3.0;
    const double radius = 1.0 - 0.3 * std::sin(2.0 * pi * (z + 0.25) / 3.0);
    return Point3(radius * std::cos(turn), radius * std::sin(turn), z);
  }).mesh;
}

/// Its own mirror image in x = 0, with a bump on each side.
TriangleMesh tallBumps()
{
  return patch(24, 30, [](double i, double j) {
    const double x = i / 12.0 - 1.0;
    const double y = j / 12.0;
    const double square = (std::abs(x) - 0.5) * (std::abs(x) - 0.5) + (y - 1.3) * (y - 1.3);
    return Point3(x, y, 0.2 * std::exp(-9.0 * square));
  }).mesh;
}

std::vector<SuggestedCurve> linesOfKind(
  const CurveSuggestions& suggestions, const std::string& kind)
{
  std::vector<SuggestedCurve> found;
  for (const auto* lines : { &suggestions.curves, &suggestions.leftOut })
  {
    for (const SuggestedCurve& line : *lines)
    {
      if (line.curve.name.compare(0, kind.size(), kind) == 0)
      {
        found.push_back(line);
      }
    }
  }
  return found;
}
}

TEST(LineSuggestion, LeadsStyleLinesOverTheBumpsOfBothSides)
{
  const CurveSuggestions suggestions = suggestLines(tallBumps(), {}, {});
  const std::vector<SuggestedCurve> lines = linesOfKind(suggestions, "style line");
  ASSERT_EQ(lines.size(), 2u);
  for (const SuggestedCurve& line : lines)
  {
    EXPECT_EQ(line.curve.type, CurveType::Accessory);
    EXPECT_NEAR(std::abs(line.curve.points[0].x()), 0.5, 0.13);
  }
  EXPECT_LT(lines[0].curve.points[0].x() * lines[1].curve.points[0].x(), 0.0);
}

TEST(LineSuggestion, MeasuresGirthsWhereTheSurfaceIsNarrowestAndWidest)
{
  const CurveSuggestions suggestions = suggestLines(vase(), {}, {});
  std::vector<double> heights;
  for (const SuggestedCurve& line : linesOfKind(suggestions, "girth"))
  {
    heights.push_back(line.curve.points[0].z());
    for (const Point3& p : line.curve.points)
    {
      EXPECT_NEAR(p.z(), heights.back(), 1e-9);
    }
  }
  std::sort(heights.begin(), heights.end());
  ASSERT_EQ(heights.size(), 2u);
  // The sine of 2 pi (z + 1/4) / 3 is 1 at z = 1/2 and -1 at z = 2; 64 sections are looked at.
  EXPECT_NEAR(heights[0], 0.5, 0.12);
  EXPECT_NEAR(heights[1], 2.0, 0.12);
}

TEST(LineSuggestion, DrawsNoLineWhereItsPlaneOnlyGrazesTheSurface)
{
  // More than half a tube, with a dent where it stands upright, at x = -1.
  const TriangleMesh mesh = patch(36, 30, [](double i, double j) {
    const double turn = 1.25 * pi - 1.5 * pi * i / 36.0;
    const double y = j / 10.0;
    const double aside = (turn - pi) * (turn - pi) + (y - 1.5) * (y - 1.5);
    const double radius = 1.0 - 0.03 * std::exp(-8.0 * aside);
    return Point3(radius * std::cos(turn), y, radius * std::sin(turn));
  }).mesh;
  SuggestionOptions options;
  options.search.symmetric = "off"; // it is its own mirror image in y = 1.5 as well
  const CurveSuggestions suggestions = suggestLines(mesh, {}, options);
  ASSERT_TRUE(suggestions.status.ok()) << suggestions.status.message;
  EXPECT_FALSE(suggestions.curves.empty());
  for (const SuggestedCurve& line : linesOfKind(suggestions, "style line"))
  {
    for (const Point3& p : line.curve.points)
    {
      EXPECT_LT(std::abs(p.x()), 0.96) << line.curve.name; // 20 degrees from upright: cos = 0.94
    }
  }
}

TEST(LineSuggestion, IsTheSameForAnyNumberOfThreadsAndEndsWhenItIsCancelled)
{
  const TriangleMesh mesh = tallBumps();
  const CurveSuggestions alone = suggestLines(mesh, {}, {});
  const CurveSuggestions many = suggestLines(mesh, {}, {}, withThreads(3));
  expectSameCurves(alone, many);
  Execution cancelled;
  cancelled.cancel = [] { return true; };
  EXPECT_EQ(suggestLines(mesh, {}, {}, cancelled).status.code, StatusCode::Cancelled);
}
