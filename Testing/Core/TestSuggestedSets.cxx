// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/PieceSewing.h"
#include "SuggestionTesting.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A closed body that is its own mirror image in x = 0, and in no other plane.
TriangleMesh pear()
{
  const TriangleMesh ball = sphere(3);
  Points3 points;
  for (const Point3& p : ball.points())
  {
    points.emplace_back(
      p.x() * (1.0 + 0.3 * p.y()), 1.3 * p.y() + 0.2 * p.z() * p.z(), p.z() * (1.0 + 0.2 * p.z()));
  }
  return { std::move(points), ball.triangles() };
}

constexpr Index columns = 32;
constexpr Index rows = 20;

/// The back of a tube that is narrower above.
TriangleMesh hip()
{
  return patch(columns, rows, [](double i, double j) {
    const double angle = 1.2 * (i / 16.0 - 1.0);
    const double height = 0.1 * j;
    const double above = std::max(0.0, height - 1.2) / 0.8;
    const double radius = 1.0 - 0.3 * above * above;
    return Point3(radius * std::sin(angle), radius * std::cos(angle), height);
  }).mesh;
}

/// What is sewn from a flat pattern with four darts from the waist.
struct Skirt
{
  TriangleMesh mesh;
  std::vector<Polyline> darts;
};

Skirt skirt()
{
  const TriangleMesh body = hip();
  Skirt result;
  for (Index column : { 6, 12, 20, 26 })
  {
    Polyline dart;
    dart.type = CurveType::Dart;
    dart.name = "designed at " + std::to_string(column);
    for (Index row = rows; row >= 12; --row)
    {
      dart.points.push_back(body.point(row * (columns + 1) + column));
    }
    result.darts.push_back(dart);
  }
  const ImprintedSurface surface = imprintCurves(body, result.darts, {});
  const FlatteningResult pattern = flattenSurface(surface.mesh, surface.curves, {}, {});
  SewingOptions options;
  options.secondStart = false;
  const SewingResult sewn = sewPieces(*pattern.cut, pattern.positions, options, {});
  EXPECT_TRUE(sewn.status.ok()) << sewn.status.message;
  Points3 points(surface.mesh.vertexCount());
  for (Index v = 0; v < pattern.cut->mesh.vertexCount(); ++v)
  {
    points[pattern.cut->originalVertex[v]] = sewn.points[v];
  }
  for (std::size_t d = 0; d < result.darts.size(); ++d)
  {
    for (std::size_t k = 0; k < result.darts[d].points.size(); ++k)
    {
      result.darts[d].points[k] = points[surface.curves[d].vertices[k]];
    }
  }
  result.mesh = TriangleMesh(std::move(points), surface.mesh.triangles());
  return result;
}

/// How far the farther end of the nearest proposal lies from that of a line.
double missOf(const Polyline& line, const CurveSuggestions& suggestions)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    const Points3& points = cut.curve.points;
    least = std::min(least,
      std::max((points.front() - line.points.front()).norm(),
        (points.back() - line.points.back()).norm()));
  }
  return least;
}
}

TEST(SuggestedSets, HalvesOfAClosedBodyAreCutAlike)
{
  SuggestionOptions options = optionsOf(0.1, 9);
  options.search.maximumWork = 8.0;
  const CurveSuggestions suggestions = suggestCurves(pear(), {}, options);
  ASSERT_TRUE(suggestions.mirror && suggestions.mirror->plane());
  // Closed it has no flattening of which anything could be said.
  EXPECT_TRUE(std::isnan(suggestions.strainBefore));
  EXPECT_TRUE(std::isnan(suggestions.curves.front().gain));
  EXPECT_GT(suggestions.curves.front().strainAfter, 0.1);
  std::size_t pairs = 0;
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    if (cut.mirrorOf == none)
    {
      // Alone only what opens the body in its mirror plane.
      const bool paired =
        std::any_of(suggestions.curves.begin(), suggestions.curves.end(), [&](const auto& other) {
          return other.mirrorOf != none && &suggestions.curves[other.mirrorOf] == &cut;
        });
      for (const Point3& point : cut.curve.points)
      {
        EXPECT_TRUE(paired || std::abs(point.x()) < 1e-9) << cut.curve.name;
      }
      continue;
    }
    ++pairs;
    const SuggestedCurve& image = suggestions.curves[cut.mirrorOf];
    EXPECT_NEAR(cut.length, image.length, 1e-12) << cut.curve.name;
    ASSERT_EQ(cut.curve.points.size(), image.curve.points.size());
    for (std::size_t k = 0; k < cut.curve.points.size(); ++k)
    {
      const Point3& point = cut.curve.points[k];
      EXPECT_LT((Point3(-point.x(), point.y(), point.z()) - image.curve.points[k]).norm(), 1e-9);
    }
  }
  EXPECT_GE(pairs, 2U);
  const FlatteningResult result = flattened(pear(), {}, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
}

TEST(SuggestedSets, FindTheDartsThatASkirtWasSewnWith)
{
  const Skirt sewn = skirt();
  SuggestionOptions options = optionsOf(0.004, 4);
  options.search.cuts = SuggestedCuts::Darts;
  options.search.maximumWork = 40.0;
  const CurveSuggestions suggestions = suggestCurves(sewn.mesh, {}, options);
  EXPECT_EQ(suggestions.curves.size(), 4U);
  const double size = std::sqrt(sewn.mesh.area() / pi);
  for (const Polyline& dart : sewn.darts)
  {
    EXPECT_LT(missOf(dart, suggestions), 0.1 * size) << dart.name;
  }
}
