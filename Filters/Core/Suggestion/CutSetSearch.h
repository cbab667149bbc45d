// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/PieceSearch.h"

namespace flattening
{
/// Cuts and what the surface is with them.
struct CutSet
{
  std::vector<SuggestedCurve> cuts;
  TrialOutcome outcome;
  SearchEnd end = SearchEnd::NothingHelps;
  /// Where it was given up, how many cuts the bound would take if each did as much as those so far;
  /// where it takes more than may be, how many.
  double cutsNeeded = 0.0;
};

/// Whether a set has no more cuts than may be, and no longer ones.
bool keepsLimits(const CutSet& set, const SearchOptions& wanted);

/// How many pieces a set has beyond the number that is wanted.
Index excessPieces(const CutSet& set, const SearchOptions& wanted);

/// Whether one set is before another. First are those that meet the bound, then those that do not,
/// those with pieces that fold or overlap, and those without a flattening. Of one kind the set with
/// fewer pieces beyond the number that is wanted is first. Then sets that meet the bound go by
/// their price; others by how many pieces fold or overlap, and by strain; all, without a bound, by
/// the product of the mean of the rigid energy and, counted twice, the square of the mean change of
/// area. \param area of the surface
bool isBetter(const CutSet& a, const CutSet& b, const SearchOptions& wanted, double area);

/// The best of some sets, of which there is one at least.
const CutSet& bestOf(const std::vector<CutSet>& sets, const SearchOptions& wanted, double area);

/// The same, or, where the best one misses the bound by far, the one of which the least area does:
/// one piece of many that cannot be sewn is better than a surface that cannot.
const CutSet& leastFailing(
  const std::vector<CutSet>& sets, const SearchOptions& wanted, double area);

/// One search for a set of cuts: round by round the best cut of the piece that is distorted most,
/// then what is not needed is taken back, or, where the bound is not met, each cut is looked for
/// anew given all others. The surface's curves must be sound.
///
/// It is given up where the first cuts lower what the search is to lower so little that at this
/// rate the bound, which asks for a share of strain^2 (or strain^4), would take several times the
/// most cuts: a surface of noise is no nearer to flat after eight darts, and the forecast knows as
/// little where to lay them. \param first cuts that there are whatever the bound, with what the
/// surface is with them; they stay
CutSet searchCuts(
  const SearchSubject& subject, CutSet first, TrialBudget& budget, const Execution& execution);

/// The outcome with legs of darts as they are to lie. Where a piece misses the bound so, its darts
/// become seams that end inside, whose sides need not fold on each other.
/// \param curves of the surface, before the cuts in the trials
CutSet withFolds(CutSet set, const CutTrials& trials, std::size_t curves, double bound,
  TrialBudget& budget, const Execution& execution);

/// Sets that would take as many times the most cuts are given up.
inline constexpr double farTooManyCuts = 4.0;

/// More cuts than these are not measured one by one.
inline constexpr Index maxMeasuredCuts = 12;

/// Measures what each cut gives after those before it; what the work does not allow is not known.
/// \param without, with all cuts \param area of the surface
void measureCuts(const CutTrials& trials, const TrialOutcome& without, const TrialOutcome& with,
  double area, std::vector<SuggestedCurve>& cuts, TrialBudget& budget, const Execution& execution);

/// A strategy of search, beside the options.
struct SearchStrategy
{
  SuggestedCuts cuts = SuggestedCuts::All;
  SearchGoal goal = SearchGoal::Energy;
};

/// The strategies of search one after the other, the most promising first: by two goals, and where
/// darts and seams are wanted also with either alone.
std::vector<SearchStrategy> searchStrategies(const SearchOptions& options);
}
