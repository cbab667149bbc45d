// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/SearchedPiece.h"

namespace flattening
{
/// Plans that differ from one by an end, or the place that a seam runs over, moved by a step either
/// way, in the surface's unit: ends on the boundary along it, tips along the cut and across. What a
/// plan is to the mirror it stays.
std::vector<CutPlan> movedPlans(const SearchedPiece& piece, const CutPlan& plan, double step);
/// Plans of a dart from the boundary that differ from one as a whole: base and tip moved along the
/// boundary by a step either way. None of other plans. \param turned also those whose tip moves
/// against the base, so that the dart turns about its middle
std::vector<CutPlan> slidPlans(
  const SearchedPiece& piece, const CutPlan& plan, double step, bool turned);
}
