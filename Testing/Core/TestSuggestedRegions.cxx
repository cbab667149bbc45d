// SPDX-License-Identifier: BSD-3-Clause

#include "SuggestionTesting.h"

using namespace flattening;
using namespace testmeshes;

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

TEST(CurveSuggestion, RefusesWhatAreNoWeights)
{
  const TriangleMesh mesh = twoBumps();
  SuggestionOptions options = optionsOf(0.02, 4);
  options.weights.assign(mesh.triangleCount() - 1, 1.0);
  EXPECT_EQ(suggestCurves(mesh, {}, options).status.code, StatusCode::InvalidOption);
  options.weights.assign(mesh.triangleCount(), 0.0);
  EXPECT_EQ(suggestCurves(mesh, {}, options).status.code, StatusCode::InvalidOption);
  for (double wrong : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    options.weights.assign(mesh.triangleCount(), 1.0);
    options.weights[7] = wrong;
    const Status status = suggestCurves(mesh, {}, options).status;
    EXPECT_EQ(status.code, StatusCode::InvalidOption);
    EXPECT_EQ(status.ids.kind, ElementKind::Cells);
    EXPECT_EQ(status.ids.values, std::vector<std::int64_t>{ 7 });
  }
}
