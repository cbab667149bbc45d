// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutSearch.h"

#include "Suggestion/DistinctPlans.h"
#include "Suggestion/MovedPlans.h"

#include <algorithm>
#include <iterator>

namespace flattening
{
namespace
{
/// In sqrt(area / pi): how far a cut's ends are moved at first, and at last.
constexpr double firstStep = 0.12;
constexpr double lastStep = 0.025;
/// A cut whose ends are so near to those of another, in the same unit, was tried with that.
constexpr double samePlace = 5e-3;
/// A seam that cuts off less than this share of the area is no seam.
constexpr double leastPiece = 0.03;
/// Moves are taken that raise the score by more than this share.
constexpr double leastRise = 0.005;
constexpr Index mostMoves = 12;
/// So many of the best are polished.
constexpr std::size_t polishedCuts = 2;

/// The plans of types that none of some others is of.
std::vector<CutPlan> ofOtherTypes(
  const std::vector<CutPlan>& plans, const std::vector<CutPlan>& others)
{
  std::vector<CutPlan> left;
  std::copy_if(plans.begin(), plans.end(), std::back_inserter(left), [&](const CutPlan& plan) {
    return std::none_of(
      others.begin(), others.end(), [&](const CutPlan& other) { return other.type == plan.type; });
  });
  return left;
}
}

CutSearch::CutSearch(const SearchedPiece& piece, const CutTrials& trials,
  const SearchOptions& options, const TrialOutcome& before)
  : Piece(piece)
  , Trials(trials)
  , Options(options)
  , Before(before)
{
}

std::vector<TriedCut> CutSearch::tryAll(const std::vector<CutPlan>& plans, double longest,
  TrialBudget& budget, const Execution& execution) const
{
  std::vector<std::vector<Polyline>> cuts;
  cuts.resize(plans.size());
  execution.parallelFor(static_cast<Index>(plans.size()), [&](Index begin, Index end) {
    for (Index k = begin; k < end; ++k)
    {
      cuts[k] = this->Piece.polylines(plans[k]);
    }
  });
  std::vector<TrialOutcome> outcomes = this->Trials.runAll(cuts, budget, execution);
  std::vector<TriedCut> tried;
  for (std::size_t k = 0; k < plans.size(); ++k)
  {
    TriedCut cut{ plans[k], std::move(outcomes[k]), 0.0, 0.0 };
    const double length = cut.outcome.cutLength();
    const double least = this->Options.leastLength * this->Piece.size();
    const bool seam = plans[k].type == CurveType::Seam;
    if (cuts[k].empty() || !cut.outcome.soundAfter(this->Before) || length > longest ||
      length < least * static_cast<double>(cut.outcome.lengths.size()) ||
      (seam && cut.outcome.leastPiece < leastPiece))
    {
      continue;
    }
    cut.gain = this->Before.goal - cut.outcome.goal;
    cut.plan.length = length;
    cut.plan.price = this->Piece.price(cut.plan, length, this->Options);
    cut.score = cut.gain / cut.plan.price;
    if (cut.gain > 0.0)
    {
      tried.push_back(std::move(cut));
    }
  }
  std::stable_sort(
    tried.begin(), tried.end(), [](const TriedCut& a, const TriedCut& b) { return a.better(b); });
  return tried;
}

std::vector<TriedCut> CutSearch::run(const std::vector<CutPlan>& plans, double longest,
  TrialBudget& budget, const Execution& execution) const
{
  const std::vector<CutPlan> first = distinctPlans(this->Piece, plans, this->Options.trials);
  std::vector<TriedCut> tried = this->tryAll(first, longest, budget, execution);
  if (tried.empty())
  {
    // On a ring that ripples all seams may overlap, and fill the trials.
    tried =
      this->tryAll(distinctPlans(this->Piece, ofOtherTypes(plans, first), this->Options.trials),
        longest, budget, execution);
  }
  for (std::size_t k = 0; k < std::min(tried.size(), polishedCuts); ++k)
  {
    tried[k] = this->polished(std::move(tried[k]), longest, budget, execution);
  }
  std::stable_sort(
    tried.begin(), tried.end(), [](const TriedCut& a, const TriedCut& b) { return a.better(b); });
  return tried;
}

TriedCut CutSearch::polished(
  TriedCut cut, double longest, TrialBudget& budget, const Execution& execution) const
{
  double step = firstStep * this->Piece.size();
  std::vector<CutPlan> before{ cut.plan };
  for (Index move = 0; move < mostMoves && step >= lastStep * this->Piece.size(); ++move)
  {
    if (budget.spent() || execution.cancelled())
    {
      break;
    }
    std::vector<CutPlan> plans = movedPlans(this->Piece, cut.plan, step);
    plans.erase(std::remove_if(plans.begin(), plans.end(),
                  [&](const CutPlan& plan) { return this->isAmong(before, plan); }),
      plans.end());
    before.insert(before.end(), plans.begin(), plans.end());
    std::vector<TriedCut> tried = this->tryAll(plans, longest, budget, execution);
    if (!tried.empty() && tried.front().score > (1.0 + leastRise) * cut.score)
    {
      cut = std::move(tried.front());
    }
    else
    {
      step *= 0.5;
    }
  }
  return cut;
}

bool CutSearch::isAmong(const std::vector<CutPlan>& plans, const CutPlan& plan) const
{
  const auto near = [&](const Point3& a, const Point3& b) {
    return (a - b).norm() < samePlace * this->Piece.size();
  };
  return std::any_of(plans.begin(), plans.end(), [&](const CutPlan& other) {
    return near(this->Piece.baseOf(plan), this->Piece.baseOf(other)) &&
      near(this->Piece.endOf(plan), this->Piece.endOf(other)) &&
      (!plan.via || near(*plan.via, *other.via));
  });
}
}
