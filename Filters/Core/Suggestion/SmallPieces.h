// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutSetSearch.h"

namespace flattening
{
/// A set without stretches of seams between a small piece and a neighbor that keep the bound
/// together, and without the images of such stretches, the smallest pieces first: where seams are
/// drawn straight slivers are left between them, which are more work to sew than they save strain.
/// The same set where there are none, without a bound, where a surface has other curves or weights,
/// or where a number of pieces is wanted. \param whole trials of the subject
CutSet withoutSmallPieces(CutSet set, const SearchSubject& subject, const CutTrials& whole,
  TrialBudget& budget, const Execution& execution);
}
