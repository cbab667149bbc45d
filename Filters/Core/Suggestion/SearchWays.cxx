// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SearchWays.h"

namespace flattening
{
std::vector<SearchWay> searchWays(const SearchOptions& options)
{
  std::vector<SearchWay> all;
  for (SuggestedCuts cuts : { SuggestedCuts::All, SuggestedCuts::Darts, SuggestedCuts::Seams })
  {
    if (cuts == options.cuts || options.cuts == SuggestedCuts::All)
    {
      all.push_back({ cuts, SearchGoal::Energy });
      all.push_back({ cuts, options.bound > 0.0 ? SearchGoal::Strain : SearchGoal::Area });
    }
  }
  all.resize(options.maximumCuts <= singleSearch ? 1 : all.size());
  return all;
}
}
