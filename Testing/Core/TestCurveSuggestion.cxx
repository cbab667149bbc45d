// SPDX-License-Identifier: BSD-3-Clause
#include "Design/LineSuggestion.h"
#include "Suggestion/CutThinning.h"
#include "SuggestionTesting.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A dome over a square, its own mirror image in x = 0 and y = 0.
TriangleMesh dome(double height)
{
  return heightField(16, [=](double x, double y) {
    return height * (1.0 - x * x) * (1.0 - 0.8 * y * y);
  }).mesh;
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

TEST(CurveSuggestion, ItsCutsBringTheStrainBelowTheBoundAndItsDartsAreNoLongerThanThatTakes)
{
  const TriangleMesh mesh = dome(0.45);
  const double before = worstStrain(flattenSurface(mesh, {}, {}, {}));
  ASSERT_GT(before, 0.06);
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, optionsOf(0.035, 10));
  ASSERT_TRUE(suggestions.boundMet);
  EXPECT_EQ(suggestions.end, SearchEnd::BoundMet);
  EXPECT_NEAR(suggestions.strainBefore, before, 1e-12);
  const FlatteningResult result = flattened(mesh, {}, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_EQ(suggestions.curves.back().strainAfter, suggestions.strainAfter);
  EXPECT_LE(worstStrain(result), 0.035);
  EXPECT_NEAR(worstStrain(result), suggestions.strainAfter, 1e-9);
  Index darts = 0;
  for (std::size_t k = 0; k < suggestions.curves.size(); ++k)
  {
    const SuggestedCurve& cut = suggestions.curves[k];
    if (cut.curve.type == CurveType::Dart && cut.mirrorOf == none)
    {
      ++darts;
      EXPECT_GT(cut.length, 0.1);
      const auto shorter = withShare(suggestions.curves, k, 0.95);
      EXPECT_GT(worstStrain(flattened(mesh, {}, shorter)), 0.035) << cut.curve.name;
    }
  }
  EXPECT_GT(darts, 0);
}

TEST(CurveSuggestion, MirrorsItsCutsOnAMirroredSurface)
{
  const TriangleMesh mesh = twoBumps();
  const CurveSuggestions suggestions =
    suggestCurves(mesh, {}, optionsOf(0.0, 2, SuggestedCuts::Darts));
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
  EXPECT_LE(suggestCurves(mesh, {}, optionsOf(0.0, 1, SuggestedCuts::Darts)).curves.size(), 1u);
}

TEST(CurveSuggestion, KeepsToItsLimits)
{
  const TriangleMesh mesh = dome(0.6);
  SuggestionOptions options = optionsOf(0.0, 3);
  options.search.symmetric = "off";
  options.search.maximumCutLength = 0.9;
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
  EXPECT_FALSE(suggestions.boundMet);
  ASSERT_FALSE(suggestions.curves.empty());
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    EXPECT_GT(cut.gain, 0.0);
  }
  EXPECT_LE(totalLength(suggestions.curves), 0.9);

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
  const Polyline key = lineOver(mesh, rowCurve(16, 8).vertices, CurveType::Key, "across");
  const Polyline hem = lineOver(mesh, rowCurve(16, 0).vertices, CurveType::Accessory, "hem");
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

TEST(CurveSuggestion, ItsProgressNeverFallsAndIsThatOfTheWhole)
{
  Execution execution;
  std::vector<double> fractions;
  bool doneBefore = false;
  execution.progress = [&](double fraction, const char* phase) {
    fractions.push_back(fraction);
    doneBefore = doneBefore || (fraction < 1.0 && std::string(phase) == "Done");
  };
  const SuggestionOptions options = optionsOf(0.0, 4, SuggestedCuts::All, 5.0);
  ASSERT_TRUE(suggestCurves(dome(0.5), {}, options, execution).status.ok());
  ASSERT_GT(fractions.size(), 1U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_FALSE(doneBefore);
}

TEST(CurveSuggestion, GivesNoiseUpAndSaysHowManyCutsItWouldTake)
{
  const CurveSuggestions suggestions = suggestCurves(noise(), {}, optionsOf(0.005, 8));
  EXPECT_EQ(suggestions.end, SearchEnd::GivenUp);
  EXPECT_FALSE(suggestions.boundMet);
  EXPECT_GT(suggestions.cutsNeeded, 16.0);
  EXPECT_LT(suggestions.curves.size(), 8u);
}

TEST(CurveSuggestion, IsLooserWhereTheBoundTakesMoreSeamsThanCanBeSewn)
{
  const TriangleMesh bumps = patch(56, 56, [](double i, double j) {
    return Point3(0.2 * i, 0.2 * j, 0.6 * std::sin(0.2 * pi * i) * std::sin(0.2 * pi * j));
  }).mesh;
  const SuggestionOptions options = optionsOf(0.01, 0, SuggestedCuts::Seams);
  const CurveSuggestions suggestions = suggestCurves(bumps, {}, options);
  EXPECT_FALSE(suggestions.boundMet);
  EXPECT_EQ(suggestions.end, SearchEnd::CutsUsedUp);
  EXPECT_GT(suggestions.cutsNeeded, 500.0);
  EXPECT_LE(suggestions.curves.size(), 500U);
  EXPECT_LT(suggestions.strainAfter, 0.04); // 0.46 without cuts
}

TEST(CurveSuggestion, CutsLargeSurfacesWithTheWorkOfSmallOnes)
{
  const TriangleMesh mesh = heightField(160, [](double x, double y) {
    const double side = (x - 0.5) * (x - 0.5) + (y + 0.4) * (y + 0.4);
    return 0.8 * std::exp(-3.0 * (x * x + y * y)) + 0.24 * std::exp(-20.0 * side);
  }).mesh;
  SuggestionOptions options;
  options.search.maximumWork = 4.5;
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
  EXPECT_TRUE(suggestions.boundMet);
  EXPECT_LE(suggestions.strainAfter, options.search.bound);
  const FlatteningResult result = flattened(mesh, {}, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LE(worstStrain(result), options.search.bound);
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
  expectSameCurves(alone, many);
}

TEST(CurveSuggestion, ItsWorkIsBoundedAtAnySizeAndNoneLeavesMoreStrain)
{
  for (Index size : { 10, 30, 80 })
  {
    const TriangleMesh mesh = heightField(size, [](double x, double y) {
      return 0.7 * (1.0 - x * x) * (1.0 - 0.8 * y * y);
    }).mesh;
    const double uncut = worstStrain(flattenSurface(mesh, {}, {}, {}));
    for (double work : { 0.01, 0.8 })
    {
      const CurveSuggestions suggestions =
        suggestCurves(mesh, {}, optionsOf(0.01, 6, SuggestedCuts::All, work));
      ASSERT_TRUE(suggestions.status.ok());
      // What is under way may end: a batch of trials on a small version.
      EXPECT_LT(suggestions.work, work + 1.0) << size;
      EXPECT_LE(suggestions.curves.size(), 6U);
      if (!std::isnan(suggestions.strainAfter))
      {
        EXPECT_LE(suggestions.strainAfter, suggestions.strainBefore);
        EXPECT_LE(worstStrain(flattened(mesh, {}, suggestions)), uncut + 1e-9);
      }
    }
  }
}

TEST(CurveSuggestion, TakesNoMoreCutsThanAllowedToOpenASurface)
{
  // Around a torus and through it.
  for (Index most : { 1, 6 })
  {
    const CurveSuggestions suggestions =
      suggestCurves(torus(16, 3.0), {}, optionsOf(0.1, most, SuggestedCuts::All, 4.0));
    EXPECT_LE(static_cast<Index>(suggestions.curves.size()), most);
    EXPECT_EQ(suggestions.curves.empty(), most == 1);
    EXPECT_EQ(suggestions.status.code, most == 1 ? StatusCode::InvalidOption : StatusCode::Ok);
    EXPECT_EQ(
      suggestions.status.message.find("to open the surface takes") == std::string::npos, most > 1);
  }
}

TEST(CurveSuggestion, ItsDartsNeverDivideAPiece)
{
  for (int lobes : { 2, 5 })
  {
    const TriangleMesh mesh = patch(18, 14, [lobes](double i, double j) {
      const double x = i / 9.0 - 1.0;
      const double y = j / 9.0;
      return Point3(x, y, 0.3 * std::sin(lobes * x) * std::cos(2.0 * y) + 0.2 * x * x * y);
    }).mesh;
    for (const char* symmetric : { "off", "on" })
    {
      SuggestionOptions options = optionsOf(0.005, 8, SuggestedCuts::Darts, 2.0);
      options.search.symmetric = symmetric;
      const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
      EXPECT_FALSE(suggestions.curves.empty());
      EXPECT_EQ(flattened(mesh, {}, suggestions).pieces.size(), 1U);
    }
  }
}

TEST(CurveSuggestion, IsMirroredOnlyWhereCutsAreImagesOfEachOther)
{
  for (Index most : { 1, 2, 4 })
  {
    for (const TriangleMesh& mesh : { dome(0.4), twoBumps() })
    {
      const CurveSuggestions suggestions =
        suggestCurves(mesh, {}, optionsOf(0.0, most, SuggestedCuts::All, 1.0));
      EXPECT_EQ(suggestions.mirror.has_value(), arePaired(suggestions.curves)) << most;
    }
  }
}

TEST(CurveSuggestion, PairsCutsOfASymmetricShapeWhoseTrianglesAreNotMirrored)
{
  std::mt19937 random(3);
  const auto jitter = [&random] { return 0.5 * (random() / 4294967295.0 - 0.5); };
  for (const Index columns : { 17, 24 }) // odd: alternating diagonals have no mirror image
  {
    for (const double moved : { 0.0, 1.0 })
    {
      const double half = columns / 2.0;
      const TriangleMesh mesh = patch(columns, 18, [&](double i, double j) {
        const bool inside = i > 0 && i < columns && j > 0 && j < 18;
        const double x = (i + (inside ? moved * jitter() : 0.0)) / half - 1.0;
        const double y = (j + (inside ? moved * jitter() : 0.0)) / 9.0 - 1.0;
        const double bump =
          std::exp(-8.0 * ((std::abs(x) - 0.5) * (std::abs(x) - 0.5) + (y - 0.1) * (y - 0.1)));
        return Point3(x, y, 0.25 * bump);
      }).mesh;
      const CurveSuggestions suggestions =
        suggestCurves(mesh, {}, optionsOf(0.03, 6, SuggestedCuts::Darts, 2.0));
      ASSERT_TRUE(suggestions.mirror && suggestions.mirror->plane()) << columns << " " << moved;
      for (const SuggestedCurve& cut : suggestions.curves)
      {
        if (cut.mirrorOf == none)
        {
          continue;
        }
        // Over other triangles, and so near to the image, not on it.
        const Points3& image = suggestions.curves[cut.mirrorOf].curve.points;
        for (const Point3& end : { cut.curve.points.front(), cut.curve.points.back() })
        {
          const Point3 mirrored = suggestions.mirror->mirrored(end);
          const double distance =
            std::min((mirrored - image.front()).norm(), (mirrored - image.back()).norm());
          EXPECT_LT(distance, 0.02) << columns << " " << moved << " " << cut.curve.name;
        }
      }
    }
  }
}

TEST(CurveSuggestion, RefusesAGrainAlongNoCurveBeforeTheSearch)
{
  for (const bool lines : { false, true })
  {
    for (const auto& [names, code] :
      std::vector<std::pair<std::vector<std::string>, StatusCode>>{
        { { "hem" }, StatusCode::InvalidOption }, { { "hem", "waist" }, StatusCode::InvalidOption },
        { { "dart" }, StatusCode::InvalidOption }, { { "dart 12" }, StatusCode::Ok },
        { { "hem", "grain line 1" }, StatusCode::Ok } })
    {
      SuggestionOptions options = optionsOf(0.3, 4);
      options.flattening.cloth.emplace().grain = GrainKind::Curve;
      options.flattening.cloth->grainCurves = names;
      options.flattening.cloth->grainAngles.resize(names.size());
      const auto& suggest = lines ? suggestLines : suggestCurves;
      const Status status = suggest(dome(0.2), {}, options, {}).status;
      EXPECT_EQ(status.code, code) << names.front() << ": " << status.message;
      EXPECT_EQ(status.message.find("no curve is named \"" + names.front()) != std::string::npos,
        code != StatusCode::Ok);
    }
  }
}

TEST(CurveSuggestion, SpendsItsWorkOnASearchThatEndsWhereASurfaceHadToBeOpened)
{
  const CurveSuggestions suggestions =
    suggestCurves(sphere(3), {}, optionsOf(0.1, 12, SuggestedCuts::All, 8.0));
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

namespace
{
/// By triangle, of its middle.
template <class Weight>
RegionWeights weightsOf(const TriangleMesh& mesh, Weight&& weight)
{
  RegionWeights weights;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    weights.push_back(static_cast<double>(weight(mesh.centroid(t))));
  }
  return weights;
}

/// The strain that is not exceeded on 95 % of the area on one side of x = 0.
double strainOfSide(const FlatteningResult& result, double side)
{
  std::vector<std::pair<double, double>> strains;
  double area = 0.0;
  for (Index t = 0; t < result.cut->mesh.triangleCount(); ++t)
  {
    if (result.cut->mesh.centroid(t).x() * side > 0.0)
    {
      const TriangleQuality& quality = result.triangles[t];
      strains.emplace_back(
        std::max(std::log(quality.largeStretch), -std::log(quality.smallStretch)),
        result.cut->mesh.area(t));
      area += strains.back().second;
    }
  }
  std::sort(strains.begin(), strains.end());
  double below = 0.0;
  for (const auto& [strain, share] : strains)
  {
    below += share;
    if (below >= 0.95 * area)
    {
      return strain;
    }
  }
  return 0.0;
}
}

TEST(CurveSuggestion, ProposesADartInsideAtAWaist)
{
  // Turned about y, and narrower around y = 0: saddle-like there, round above and below.
  const double half = 0.35 * pi;
  const TriangleMesh mesh = patch(16, 20, [half](double i, double j) {
    const double turn = (i / 8.0 - 1.0) * half;
    const double y = j / 5.0 - 2.0;
    const double radius = 1.0 - 0.25 * std::exp(-y * y / 0.36);
    return Point3(radius * std::sin(turn), y, radius * std::cos(turn));
  }).mesh;
  const CurveSuggestions suggestions =
    suggestCurves(mesh, {}, optionsOf(0.0, 1, SuggestedCuts::Darts));
  ASSERT_EQ(suggestions.curves.size(), 1u);
  const Polyline& dart = suggestions.curves[0].curve;
  EXPECT_EQ(dart.type, CurveType::Dart);
  // From above to below the waist, along it, and not to any edge.
  EXPECT_LT(dart.points.front().y() * dart.points.back().y(), 0.0);
  for (const Point3& tip : { dart.points.front(), dart.points.back() })
  {
    EXPECT_GT(std::abs(tip.y()), 0.2);
    EXPECT_LT(std::abs(tip.y()), 1.5);
    EXPECT_LT(std::abs(std::atan2(tip.x(), tip.z())), 0.5 * half);
  }
  EXPECT_GT(suggestions.curves[0].opening, 0.0);
  EXPECT_LT(suggestions.rigidEnergyAfter, 0.5 * suggestions.rigidEnergyBefore);
  // Its sides keep their lengths, and lie apart.
  const FlatteningResult result = flattened(mesh, {}, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  ASSERT_EQ(result.pieces.size(), 1u);
  EXPECT_EQ(result.pieces[0].boundaryLoops, 2);
  EXPECT_LT(result.curves.back().error, 1e-9);
}

TEST(CurveSuggestion, CutsTheBumpWhereDistortionMatters)
{
  const TriangleMesh mesh = twoBumps();
  SuggestionOptions options = optionsOf(0.0, 1, SuggestedCuts::Darts);
  for (double side : { 1.0, -1.0 })
  {
    options.weights = weightsOf(mesh, [side](const Point3& p) { return p.x() * side > 0.0; });
    const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
    ASSERT_TRUE(suggestions.status.ok()) << suggestions.status.message;
    EXPECT_FALSE(suggestions.mirror.has_value()); // the weights are not mirrored
    ASSERT_EQ(suggestions.curves.size(), 1u);
    const SuggestedCurve& cut = suggestions.curves[0];
    EXPECT_LT((cut.curve.points.back() - Point3(0.5 * side, 0.9, 0.25)).norm(), 0.4);
    EXPECT_GT(cut.gain, 0.0);
    // Measured is the strain of what counts, and of nothing else.
    const FlatteningResult result = flattened(mesh, {}, suggestions);
    EXPECT_NEAR(suggestions.strainAfter, strainOfSide(result, side), 1e-9);
    EXPECT_LT(suggestions.strainAfter, 0.8 * suggestions.strainBefore);
    EXPECT_GT(strainOfSide(result, -side), 0.8 * suggestions.strainBefore);
  }
}

TEST(CurveSuggestion, KeepsTheMirrorOfMirroredWeights)
{
  const TriangleMesh mesh = twoBumps();
  SuggestionOptions options = optionsOf(0.0, 2, SuggestedCuts::Darts);
  options.weights = weightsOf(mesh, [](const Point3& p) { return 1.0 + std::abs(p.x()); });
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
  EXPECT_TRUE(suggestions.mirror.has_value());
  ASSERT_EQ(suggestions.curves.size(), 2u);
  EXPECT_EQ(suggestions.curves[1].mirrorOf, 0);
}

TEST(CurveSuggestion, DoesTheSameWhereAllWeightsAreEqual)
{
  const TriangleMesh mesh = twoBumps();
  SuggestionOptions options = optionsOf(0.0, 2);
  const CurveSuggestions without = suggestCurves(mesh, {}, options);
  options.weights.assign(mesh.triangleCount(), 3.7);
  const CurveSuggestions with = suggestCurves(mesh, {}, options);
  ASSERT_FALSE(with.curves.empty());
  expectSameCurves(without, with);
}
