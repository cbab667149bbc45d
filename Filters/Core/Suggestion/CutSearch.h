// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutTrials.h"
#include "Suggestion/SearchedPiece.h"
#include "Suggestion/TrialBudget.h"

namespace flattening
{
/// A cut that has been flattened.
struct TriedCut
{
  CutPlan plan;
  TrialOutcome outcome;
  double gain = 0.0;  ///< drop of what the search is to lower
  double score = 0.0; ///< gain per price

  bool better(const TriedCut& other) const { return this->score > other.score; }
};

/// Finds the best next cut of a piece: ranks plans by forecast, flattens the first of them, and
/// moves the best about while that helps.
class CutSearch
{
public:
  /// All must outlive it. \param trials of the piece with the cuts that it has \param before its
  /// outcome without another cut
  CutSearch(const SearchedPiece& piece, const CutTrials& trials, const SearchOptions& options,
    const TrialOutcome& before);

  /// The cuts that lower the energy and are no longer than `longest`, the best first. Where none of
  /// the first plans does those of the types that are not among them are tried. Once the budget is
  /// spent no more are.
  std::vector<TriedCut> run(const std::vector<CutPlan>& plans, double longest, TrialBudget& budget,
    const Execution& execution) const;

private:
  std::vector<TriedCut> tryAll(const std::vector<CutPlan>& plans, double longest,
    TrialBudget& budget, const Execution& execution) const;
  TriedCut polished(
    TriedCut cut, double longest, TrialBudget& budget, const Execution& execution) const;
  bool isAmong(const std::vector<CutPlan>& plans, const CutPlan& plan) const;

  const SearchedPiece& Piece;
  const CutTrials& Trials;
  const SearchOptions& Options;
  const TrialOutcome& Before;
};
}
