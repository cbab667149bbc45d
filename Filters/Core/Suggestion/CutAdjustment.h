// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutSetSearch.h"

namespace flattening
{
/// Moves all cuts of a set about, one after the other, each by its ends and as a whole, with its
/// mirror image: what a cut gave when it was chosen need not be what it gives beside those after
/// it. What a move makes longer than the most is taken from all darts in proportion, so that length
/// goes where it does most. A move is kept that leaves less distortionOf() where there is no bound;
/// less of price times strain where there is one, and nothing above the bound once it is met,
/// whereupon cuts are taken back as in thinCuts(). Strain is here the geometric mean of its
/// quantile and its mean square's root, which tells better where a small move leads. Where cuts are
/// to be closed moves are first compared with cuts open, whatever overlaps. Cuts on which others
/// begin or end stay.
///
/// A search by patterns: R. Hooke, T. A. Jeeves, "Direct search solution of numerical and
/// statistical problems", Journal of the ACM 8(2), 1961.
/// \param firstCount how many cuts stay as they are
void adjustCuts(const SearchSubject& subject, std::size_t firstCount, CutSet& set,
  TrialBudget& budget, const Execution& execution);
}
