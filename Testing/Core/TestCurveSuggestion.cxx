// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CurveSuggestion.h"

#include "Flattening/SurfaceFlattening.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CutThinning.h"
#include "SuggestionTesting.h"
#include "TestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A dome over a square, its own mirror image in x = 0 and y = 0.
TriangleMesh dome(double height)
{
  return patch(16, 16, [=](double i, double j) {
    const double x = i / 8.0 - 1.0;
    const double y = j / 8.0 - 1.0;
    return Point3(x, y, height * (1.0 - x * x) * (1.0 - 0.8 * y * y));
  }).mesh;
}

double largestStrain(const FlatteningResult& result)
{
  double strain = 0.0;
  for (const PieceReport& piece : result.pieces)
  {
    strain = std::max(strain, piece.quality.strainP95);
  }
  return strain;
}

/// A square sheet whose vertices lie anywhere up to a third of an edge above or below it.
TriangleMesh noise()
{
  std::mt19937 random(7);
  return patch(12, 12, [&](double i, double j) {
    const double height = static_cast<double>(random()) / 4294967295.0 - 0.5;
    return Point3(i / 12.0, j / 12.0, height / 18.0);
  }).mesh;
}

}

TEST(CurveSuggestion, ProposesNothingForDevelopableSurfaces)
{
  for (const Surface& surface : { flatPatch(8, 6), cone(12, 5), cylinder(12, 6) })
  {
    const CurveSuggestions suggestions = suggestCurves(surface.mesh, {}, optionsOf(0.02, 8));
    EXPECT_TRUE(suggestions.status.ok());
    EXPECT_TRUE(suggestions.curves.empty());
    EXPECT_TRUE(suggestions.boundMet);
    EXPECT_LT(suggestions.strainBefore, 1e-9);
  }
}

TEST(CurveSuggestion, ItsCutsBringTheStrainBelowTheBound)
{
  const TriangleMesh mesh = dome(0.45);
  const double before = largestStrain(flattenSurface(mesh, {}, {}, {}));
  ASSERT_GT(before, 0.06);
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, optionsOf(0.035, 10));
  EXPECT_TRUE(suggestions.boundMet);
  EXPECT_EQ(suggestions.end, SearchEnd::BoundMet);
  EXPECT_FALSE(suggestions.curves.empty());
  EXPECT_NEAR(suggestions.strainBefore, before, 1e-12);
  const FlatteningResult result = flattened(mesh, {}, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_EQ(suggestions.curves.back().strainAfter, suggestions.strainAfter);
  EXPECT_LE(largestStrain(result), 0.035);
  EXPECT_NEAR(largestStrain(result), suggestions.strainAfter, 1e-9);
}

TEST(CurveSuggestion, ItsDartsAreNoLongerThanTheBoundAsks)
{
  const TriangleMesh mesh = dome(0.45);
  const SuggestionOptions options = optionsOf(0.035, 10);
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
  ASSERT_TRUE(suggestions.boundMet);
  Index darts = 0;
  for (std::size_t k = 0; k < suggestions.curves.size(); ++k)
  {
    const SuggestedCurve& cut = suggestions.curves[k];
    if (cut.curve.type == CurveType::Dart && cut.mirrorOf == none)
    {
      ++darts;
      EXPECT_GT(cut.length, 0.1);
      CurveSuggestions shorter;
      shorter.curves = withShare(suggestions.curves, k, 0.95);
      EXPECT_GT(largestStrain(flattened(mesh, {}, shorter)), 0.035) << cut.curve.name;
    }
  }
  EXPECT_GT(darts, 0);
}

TEST(CurveSuggestion, MirrorsItsCutsOnAMirroredSurface)
{
  const TriangleMesh mesh = twoBumps();
  SuggestionOptions options = optionsOf(0.0, 2);
  options.search.cuts = SuggestedCuts::Darts;
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
  ASSERT_TRUE(suggestions.mirror.has_value());
  EXPECT_NEAR(std::abs(suggestions.mirror->plane()->normal.x()), 1.0, 1e-9);
  ASSERT_EQ(suggestions.curves.size(), 2u);
  const SuggestedCurve& cut = suggestions.curves[0];
  const SuggestedCurve& image = suggestions.curves[1];
  EXPECT_EQ(cut.mirrorOf, none);
  EXPECT_EQ(image.mirrorOf, 0);
  ASSERT_EQ(cut.curve.points.size(), image.curve.points.size());
  for (std::size_t k = 0; k < cut.curve.points.size(); ++k)
  {
    const Point3& p = cut.curve.points[k];
    EXPECT_LT((image.curve.points[k] - Point3(-p.x(), p.y(), p.z())).norm(), 1e-9);
  }
  EXPECT_NEAR(cut.length, image.length, 1e-12);
  EXPECT_LT(cut.curve.points.front().x() * image.curve.points.front().x(), 0.0);
  // A pair is two cuts.
  options.search.maximumCuts = 1;
  EXPECT_LE(suggestCurves(mesh, {}, options).curves.size(), 1u);
}

TEST(CurveSuggestion, KeepsToItsLimits)
{
  const TriangleMesh mesh = dome(0.6);
  SuggestionOptions options = optionsOf(0.0, 3);
  options.search.symmetric = false;
  options.search.maximumCutLength = 0.9;
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
  EXPECT_FALSE(suggestions.boundMet);
  ASSERT_FALSE(suggestions.curves.empty());
  EXPECT_LE(suggestions.curves.size(), 3u);
  double length = 0.0;
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    length += cut.length;
    EXPECT_GT(cut.gain, 0.0);
  }
  EXPECT_LE(length, 0.9);

  options.search.cuts = SuggestedCuts::Seams;
  options.search.maximumCuts = 1;
  options.search.maximumCutLength = 1e9;
  for (const SuggestedCurve& cut : suggestCurves(mesh, {}, options).curves)
  {
    EXPECT_EQ(cut.curve.type, CurveType::Seam);
  }
}

TEST(CurveSuggestion, NeverCutsAKeyCurveNorStartsWhereThatIsForbidden)
{
  const TriangleMesh mesh = dome(0.3);
  Polyline key;
  key.name = "across";
  key.type = CurveType::Key;
  Polyline hem;
  hem.name = "hem";
  for (Index i = 0; i <= 16; ++i)
  {
    key.points.push_back(mesh.point(8 * 17 + i));
    hem.points.push_back(mesh.point(i));
  }
  SuggestionOptions options = optionsOf(0.0, 2);
  options.search.preferences.push_back({ "hem", 0.0 });
  const CurveSuggestions suggestions = suggestCurves(mesh, { key, hem }, options);
  ASSERT_FALSE(suggestions.curves.empty());
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    const double side = cut.curve.points.back().y();
    for (const Point3& p : cut.curve.points)
    {
      EXPECT_GT(p.y() * side, 0.0) << cut.curve.name;
    }
    EXPECT_GT(cut.curve.points.front().y(), -1.0 + 1e-9);
  }
  const FlatteningResult result = flattened(mesh, { key, hem }, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
}

TEST(CurveSuggestion, IsTheSameForAnyNumberOfThreads)
{
  const TriangleMesh mesh = twoBumps();
  const CurveSuggestions alone = suggestCurves(mesh, {}, optionsOf(0.0, 2));
  const CurveSuggestions many = suggestCurves(mesh, {}, optionsOf(0.0, 2), withThreads(3));
  ASSERT_EQ(alone.curves.size(), many.curves.size());
  for (std::size_t k = 0; k < alone.curves.size(); ++k)
  {
    EXPECT_EQ(alone.curves[k].curve.points, many.curves[k].curve.points);
    EXPECT_EQ(alone.curves[k].gain, many.curves[k].gain);
  }
}

TEST(CurveSuggestion, ItsProgressNeverFallsAndIsThatOfTheWhole)
{
  Execution execution;
  std::vector<double> fractions;
  bool doneBefore = false;
  execution.progress = [&](double fraction, const char* phase) {
    fractions.push_back(fraction);
    doneBefore = doneBefore || (fraction < 1.0 && std::string(phase) == "Done");
  };
  ASSERT_TRUE(suggestCurves(dome(0.5), {}, optionsOf(0.0, 4), execution).status.ok());
  ASSERT_GT(fractions.size(), 1U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_FALSE(doneBefore);
}

TEST(CurveSuggestion, GivesNoiseUpAndSaysHowManyCutsItWouldTake)
{
  const CurveSuggestions suggestions = suggestCurves(noise(), {}, optionsOf(0.005, 8));
  EXPECT_EQ(suggestions.end, SearchEnd::GivenUp);
  EXPECT_FALSE(suggestions.boundMet);
  EXPECT_GT(suggestions.cutsNeeded, 32.0);
  EXPECT_LT(suggestions.curves.size(), 8u);
}

TEST(CurveSuggestion, EndsWhenItsWorkIsUsedUpWhateverTheThreads)
{
  const TriangleMesh mesh = dome(0.6);
  SuggestionOptions options = optionsOf(0.0, 8);
  const CurveSuggestions unlimited = suggestCurves(mesh, {}, optionsOf(0.0, 2));
  EXPECT_EQ(unlimited.end, SearchEnd::CutsUsedUp);
  options.search.maximumWork = 0.3 * unlimited.work;
  const CurveSuggestions alone = suggestCurves(mesh, {}, options);
  EXPECT_EQ(alone.end, SearchEnd::WorkUsedUp);
  EXPECT_LT(alone.work, unlimited.work);
  EXPECT_LT(alone.trials, unlimited.trials);
  const CurveSuggestions many = suggestCurves(mesh, {}, options, withThreads(3));
  EXPECT_EQ(alone.work, many.work);
  ASSERT_EQ(alone.curves.size(), many.curves.size());
  for (std::size_t k = 0; k < alone.curves.size(); ++k)
  {
    EXPECT_EQ(alone.curves[k].curve.points, many.curves[k].curve.points);
  }
  options.search.maximumWork = -1.0;
  EXPECT_EQ(suggestCurves(mesh, {}, options).status.code, StatusCode::InvalidOption);
}

TEST(CurveSuggestion, EndsWhenItIsCancelled)
{
  Execution execution;
  execution.cancel = [] { return true; };
  EXPECT_EQ(
    suggestCurves(dome(0.4), {}, optionsOf(0.0, 4), execution).status.code, StatusCode::Cancelled);
}

TEST(CurveSuggestion, RefusesWhatIsNoOption)
{
  for (double bound : { -0.1, std::nan("") })
  {
    EXPECT_EQ(
      suggestCurves(dome(0.2), {}, optionsOf(bound, 4)).status.code, StatusCode::InvalidOption);
  }
  SuggestionOptions options = optionsOf(0.02, 4);
  options.search.preferences.push_back({ "nobody", 2.0 });
  const Status status = suggestCurves(dome(0.2), {}, options).status;
  EXPECT_EQ(status.code, StatusCode::InvalidOption);
  EXPECT_NE(status.message.find("nobody"), std::string::npos);
}

TEST(CurveSuggestion, CutsABallIntoPiecesThatFlatten)
{
  const TriangleMesh mesh = sphere(2);
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, optionsOf(0.25, 4));
  EXPECT_TRUE(suggestions.boundMet);
  const FlatteningResult result = flattened(mesh, {}, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LE(largestStrain(result), 0.25);
  EXPECT_GT(result.pieces.size(), 1u);
}

TEST(CurveSuggestion, SpendsItsWorkOnASearchThatEndsWhereASurfaceHadToBeOpened)
{
  SuggestionOptions options = optionsOf(0.1, 12);
  options.search.maximumWork = 8.0;
  const CurveSuggestions suggestions = suggestCurves(sphere(3), {}, options);
  EXPECT_TRUE(suggestions.boundMet) << suggestions.strainAfter;
}

TEST(CurveSuggestion, TriesDartsWhereAllSeamsOverlap)
{
  // A ring that ripples has more around it than the plane has room for.
  const TriangleMesh ring = rolledUp(30, 6, [](double turn, double across) {
    return Point3((1.0 + across) * std::cos(turn), (1.0 + across) * std::sin(turn),
      0.35 * across * std::sin(2.0 * turn));
  });
  const CurveSuggestions suggestions = suggestCurves(ring, {}, optionsOf(0.02, 3));
  ASSERT_FALSE(suggestions.curves.empty());
  EXPECT_LT(suggestions.strainAfter, suggestions.strainBefore);
}
