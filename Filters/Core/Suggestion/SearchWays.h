// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/SearchOptions.h"
#include "Suggestion/SurfaceMirror.h"

#include <optional>

namespace flattening
{
/// One way to search, beside the options.
struct SearchWay
{
  SearchGoal goal = SearchGoal::Energy;
  bool mirrored = true;
  double fixedPrice = 1.0; ///< times that of the options
  bool unsettled = false;  ///< see SearchOptions
};

/// Where few cuts may be made, which are wanted soon.
bool searchesOnce(const SearchOptions& options);

/// The ways to search one after the other: one where that is enough. \param mirror of the surface
std::vector<SearchWay> searchWays(
  const SearchOptions& options, const std::optional<SurfaceMirror>& mirror);
}
