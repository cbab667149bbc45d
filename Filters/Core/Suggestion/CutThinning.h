// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CurveSuggestions.h"
#include "Suggestion/CutTrials.h"

namespace flattening
{
/// Takes back what the bound does not need of some cuts: whole cuts, and thirds, tenths and less of
/// darts from the tip on, mirror images together, as long as the strain stays within the bound;
/// what saves most first.
/// \param least length of a dart that is left \param now the outcome of the cuts, in and out
void thinCuts(const CutTrials& trials, double bound, double least,
  std::vector<SuggestedCurve>& cuts, TrialOutcome& now, TrialBudget& budget,
  const Execution& execution);

/// The first part of a line, of this length.
Points3 shortened(const Points3& line, double length);

/// Of cuts, by cutPrice for each beside its length over a size.
double priceOf(const std::vector<SuggestedCurve>& cuts, double size);

std::vector<Polyline> linesOf(const std::vector<SuggestedCurve>& cuts);

/// Hands on cuts that are found so far.
void previewCuts(const std::vector<SuggestedCurve>& cuts, const Execution& execution);

/// The cuts with one and its mirror image left out, or cut back to a share of its length.
std::vector<SuggestedCurve> withShare(
  const std::vector<SuggestedCurve>& cuts, std::size_t which, double share);
}
