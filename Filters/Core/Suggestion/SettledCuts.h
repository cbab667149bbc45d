// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutTrials.h"
#include "Suggestion/SearchedPiece.h"

namespace flattening
{
/// The lines of a plan as they are proposed: by the points where they cross the surface's edges
/// beside some other cuts, the two of a pair exact images on a piece that is its own, and equally
/// long darts on another. Empty where they cannot be made.
std::vector<Polyline> settledCuts(const CutTrials& trials, const std::vector<Polyline>& others,
  const std::vector<Polyline>& lines, const SearchedPiece& piece);
}
