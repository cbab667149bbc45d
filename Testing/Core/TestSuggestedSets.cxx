// SPDX-License-Identifier: BSD-3-Clause
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
}

TEST(SuggestedSets, HalvesOfAClosedBodyAreCutAlike)
{
  SuggestionOptions options = optionsOf(0.1, 9);
  options.search.maximumWork = 8.0;
  const CurveSuggestions suggestions = suggestCurves(pear(), {}, options);
  ASSERT_TRUE(suggestions.mirror && suggestions.mirror->plane());
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
