// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SearchWays.h"

namespace flattening
{
namespace
{
/// Up to so many cuts are searched for once.
constexpr Index singleSearch = 2;
}

bool searchesOnce(const SearchOptions& options)
{
  return options.maximumCuts <= singleSearch;
}

std::vector<SearchWay> searchWays(
  const SearchOptions& options, const std::optional<SurfaceMirror>& mirror)
{
  // A mirror that holds only nearly is no reason to keep a single cut to its axis.
  const bool alone = options.maximumCuts == 1 && mirror && mirror->intrinsic() &&
    mirror->error > SurfaceMirror::exact;
  const bool mirrored = mirror.has_value() && !alone;
  std::vector<SearchWay> all{ { SearchGoal::Energy, mirrored, 1.0 } };
  if (searchesOnce(options))
  {
    return all;
  }
  if (options.bound > 0.0)
  {
    all.push_back({ SearchGoal::Energy, mirrored, 1.0, true });
    all.push_back({ SearchGoal::Strain, mirrored, 1.0, true });
    all.push_back({ SearchGoal::Strain, mirrored, 1.0 });
  }
  else
  {
    all.push_back({ SearchGoal::Area, mirrored, 2.5 });
    all.push_back({ SearchGoal::Area, mirrored, 1.0 });
  }
  all.push_back({ SearchGoal::Energy, mirrored, 2.5 });
  if (mirrored && mirror->error > SurfaceMirror::exact)
  {
    const std::size_t count = all.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      all.push_back(all[k]);
      all.back().mirrored = false;
    }
  }
  return all;
}
}
