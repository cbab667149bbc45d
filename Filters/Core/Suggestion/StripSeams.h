// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutSetSearch.h"

namespace flattening
{
/// Charts are given up that take as many cuts in each part of the surface where the number is not
/// limited.
inline constexpr double maxChartCuts = 500.0;

/// Adds seams, straight in the plane, that part flat pieces wider than SearchOptions::maximumWidth
/// into strips of equal widths, as long as the limits of cuts allow. The width of a piece is
/// measured where it is least: the distance of the nearest two parallel lines that it lies between.
/// Pieces that are mirror images are parted alike. \param width gets that of the widest piece, the
/// one allowed where it is greater by rounding
CutSet inStrips(CutSet set, const SearchSubject& subject, TrialBudget& budget,
  const Execution& execution, double& width);
}
