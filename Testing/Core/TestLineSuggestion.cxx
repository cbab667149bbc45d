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

Point3 onTwoBumps(double x, double y)
{
  const double square = (std::abs(x) - 0.5) * (std::abs(x) - 0.5) + (y - 1.3) * (y - 1.3);
  return { x, y, 0.2 * std::exp(-9.0 * square) };
}

/// Its own mirror image in x = 0, with a bump on each side.
TriangleMesh tallBumps()
{
  return patch(24, 30, [](double i, double j) {
    return onTwoBumps(i / 12.0 - 1.0, j / 12.0);
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

TEST(LineSuggestion, DrawsTheCentreLineInTheMirrorPlaneFromEdgeToEdge)
{
  const CurveSuggestions suggestions = suggestLines(tallBumps(), {}, {});
  ASSERT_TRUE(suggestions.status.ok()) << suggestions.status.message;
  ASSERT_FALSE(suggestions.curves.empty());
  const Polyline& line = suggestions.curves[0].curve;
  EXPECT_EQ(line.name, "centre line 1");
  EXPECT_EQ(line.type, CurveType::Key);
  EXPECT_EQ(line.keyShape, KeyShape::Straight);
  double low = 1.0;
  double high = 1.0;
  for (const Point3& p : line.points)
  {
    EXPECT_NEAR(p.x(), 0.0, 1e-9);
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  EXPECT_NEAR(low, 0.0, 1e-9);
  EXPECT_NEAR(high, 2.5, 1e-9);
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

TEST(LineSuggestion, TellsThePriceThatAFlatteningHas)
{
  const TriangleMesh mesh = tallBumps();
  const CurveSuggestions suggestions = suggestLines(mesh, {}, {});
  std::vector<Polyline> curves;
  for (const SuggestedCurve& line : suggestions.curves)
  {
    curves.push_back(line.curve);
    const ImprintedSurface surface = imprintCurves(mesh, curves, {});
    FlatteningOptions options;
    options.arrange = false;
    const FlatteningResult flat = flattenSurface(surface.mesh, surface.curves, options, {});
    ASSERT_EQ(flat.pieces.size(), 1u);
    EXPECT_NEAR(line.areaErrorAfter, flat.pieces[0].quality.areaError, 1e-9);
    EXPECT_NEAR(line.strainAfter, flat.pieces[0].quality.strainP95, 1e-9);
  }
  ASSERT_FALSE(curves.empty());
  for (const SuggestedCurve& line : suggestions.leftOut)
  {
    EXPECT_TRUE(!line.sound || -line.gain > 0.05 * suggestions.rigidEnergyBefore)
      << line.curve.name;
  }
}

TEST(LineSuggestion, FindsNoGirthAndNoStyleLineOnACylinder)
{
  const TriangleMesh mesh = patch(12, 20, [](double i, double j) {
    return Point3(std::cos(pi * i / 12.0), std::sin(pi * i / 12.0), j / 4.0);
  }).mesh;
  const CurveSuggestions suggestions = suggestLines(mesh, {}, {});
  EXPECT_TRUE(linesOfKind(suggestions, "girth").empty());
  EXPECT_TRUE(linesOfKind(suggestions, "style line").empty());
  ASSERT_EQ(suggestions.curves.size(), 1u);
  EXPECT_LT(suggestions.strainAfter, 1e-9);
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

TEST(LineSuggestion, LeavesAPieceItsOwnKeyCurve)
{
  const TriangleMesh mesh = tallBumps();
  Polyline key;
  key.type = CurveType::Key;
  key.name = "mine";
  for (int j = 8; j < 13; ++j)
  {
    key.points.push_back(onTwoBumps(0.25, j / 12.0));
  }
  const CurveSuggestions suggestions = suggestLines(mesh, { key }, {});
  ASSERT_TRUE(suggestions.status.ok()) << suggestions.status.message;
  EXPECT_TRUE(linesOfKind(suggestions, "centre line").empty());
  EXPECT_TRUE(linesOfKind(suggestions, "grain line").empty());
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

TEST(LineSuggestion, LeavesOutKeysThatCollapseATriangle)
{
  // The line through the middle passes a vertex so near that two edges of a triangle become its.
  const TriangleMesh mesh = patch(10, 10, [](double i, double j) {
    return Point3(0.1 * i, 0.15 * j, 0.3 * std::sin(0.3 * i) * std::sin(0.3 * j));
  }).mesh;
  const CurveSuggestions suggestions = suggestLines(mesh, {}, {});
  const FlatteningResult result = flattened(mesh, {}, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  for (const TriangleQuality& triangle : result.triangles)
  {
    EXPECT_GT(triangle.areaRatio, 0.5);
  }
}
