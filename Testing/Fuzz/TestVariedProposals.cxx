// SPDX-License-Identifier: BSD-3-Clause
// Proposals of cuts on surfaces of every shape: solids of few triangles, balls, tori, tubes,
// sheets.
#include "HostileSurface.h"
#include "Suggestion/CurveSuggestion.h"
#include "Surface/SurfacePreparation.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace hostile;

namespace
{
void propose(unsigned first, unsigned count)
{
  unsigned proposed = 0;
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    std::mt19937 random(seed);
    const Specimen specimen = makeVariedSurface(random);
    SCOPED_TRACE(specimen.name + ", seed " + std::to_string(seed));
    const PreparedSurface surface =
      prepareSurface(specimen.points, specimen.triangles, CoincidentPoints::Keep);
    ASSERT_TRUE(surface.status.ok()) << surface.status.message;
    for (const auto& [kind, most] : { std::pair(SuggestedCuts::Darts, 1),
           std::pair(SuggestedCuts::Seams, 2), std::pair(SuggestedCuts::All, 4) })
    {
      SuggestionOptions options;
      options.search.bound = 0.05;
      options.search.cuts = kind;
      options.search.maximumCuts = most;
      options.search.maximumWork = 0.5;
      const CurveSuggestions suggestions = suggestCurves(surface.mesh, {}, options);
      if (suggestions.status.refused())
      {
        EXPECT_TRUE(suggestions.curves.empty());
        EXPECT_FALSE(suggestions.status.message.empty());
        continue;
      }
      EXPECT_LE(static_cast<int>(suggestions.curves.size()), most);
      for (const SuggestedCurve& cut : suggestions.curves)
      {
        EXPECT_TRUE(std::isfinite(cut.length) && cut.length > 0.0);
      }
      proposed += kind == SuggestedCuts::All && !suggestions.curves.empty() ? 1 : 0;
    }
  }
  EXPECT_GT(proposed, count / 4);
}
}

TEST(VariedFewProposals, AreFoundOrRefusedOnEverySurface)
{
  propose(0, 12);
}

TEST(VariedProposals, AreFoundOrRefusedOnManySurfaces)
{
  propose(100, 250);
}
