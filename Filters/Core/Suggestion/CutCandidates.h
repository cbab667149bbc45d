// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Suggestion/SearchedPiece.h"

namespace flattening
{
/// In sqrt(area / pi), between the places of the boundary where planned cuts begin.
inline constexpr double baseSpacing = 0.12;

/// Plans for one cut, or a pair of mirror images: darts from places along the boundary to places
/// spread over the inside, darts inside between two places of much curvature, seams between places
/// of the boundary, the shortest way or nearly straight over a place that is far from flat, in the
/// order of forecast gain per price. Left out are darts that would overlap.
/// \param longest length of a plan's cuts, in all
std::vector<CutPlan> planCuts(const SearchedPiece& piece, const ScaleFactor& factor,
  const SearchOptions& options, double longest, const Execution& execution);
}
