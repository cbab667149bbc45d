// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/SearchOptions.h"

#include <vector>

namespace flattening
{
/// Up to this many cuts are searched for once.
constexpr Index singleSearch = 2;

/// One way to search, beside the options.
struct SearchWay
{
  SuggestedCuts cuts = SuggestedCuts::All;
  SearchGoal goal = SearchGoal::Energy;
};

/// The ways to search one after the other, the most promising first: by two goals, and where darts
/// and seams are wanted also with either alone.
std::vector<SearchWay> searchWays(const SearchOptions& options);
}
