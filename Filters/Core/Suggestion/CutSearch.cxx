// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutSearch.h"

#include "Suggestion/CutCandidates.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// In sqrt(area / pi): how far a cut's ends are moved at first, and at last.
constexpr double firstStep = 0.12;
constexpr double lastStep = 0.025;
/// Moves are taken that raise the score by more than this share.
constexpr double leastProgress = 0.005;
constexpr Index mostMoves = 12;
/// So many of the best are polished.
constexpr std::size_t polishedCuts = 2;
}

CutSearch::CutSearch(const SearchedPiece& piece, const CutTrials& trials,
  const SearchOptions& options, const TrialOutcome& before)
  : Piece(piece)
  , Trials(trials)
  , Options(options)
  , Before(before)
{
}

std::vector<TriedCut> CutSearch::tryAll(
  const std::vector<CutPlan>& plans, double longest, const Execution& execution) const
{
  std::vector<std::vector<Polyline>> cuts;
  cuts.resize(plans.size());
  execution.parallelFor(static_cast<Index>(plans.size()), [&](Index begin, Index end) {
    for (Index k = begin; k < end; ++k)
    {
      cuts[k] = this->Piece.polylines(plans[k]);
    }
  });
  std::vector<TrialOutcome> outcomes = this->Trials.runAll(cuts, execution);
  std::vector<TriedCut> tried;
  for (std::size_t k = 0; k < plans.size(); ++k)
  {
    TriedCut cut{ plans[k], std::move(outcomes[k]), 0.0, 0.0 };
    const double length = cut.outcome.cutLength();
    const double least = this->Options.leastLength * this->Piece.size();
    if (cuts[k].empty() || !cut.outcome.soundAfter(this->Before) || length > longest ||
      length < least * static_cast<double>(cut.outcome.lengths.size()))
    {
      continue;
    }
    cut.gain = this->Before.energy - cut.outcome.energy;
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

std::optional<TriedCut> CutSearch::run(const std::vector<CutPlan>& plans, double longest,
  Index& trialsLeft, const Execution& execution) const
{
  const std::vector<CutPlan> first =
    distinctPlans(this->Piece, plans, std::min(this->Options.trials, trialsLeft));
  trialsLeft -= static_cast<Index>(first.size());
  std::vector<TriedCut> tried = this->tryAll(first, longest, execution);
  std::optional<TriedCut> best;
  for (std::size_t k = 0; k < std::min(tried.size(), polishedCuts); ++k)
  {
    TriedCut cut = this->polished(std::move(tried[k]), longest, trialsLeft, execution);
    if (!best || cut.better(*best))
    {
      best = std::move(cut);
    }
  }
  return best;
}

TriedCut CutSearch::polished(
  TriedCut cut, double longest, Index& trialsLeft, const Execution& execution) const
{
  double step = firstStep * this->Piece.size();
  for (Index move = 0; move < mostMoves && step >= lastStep * this->Piece.size(); ++move)
  {
    const std::vector<CutPlan> plans = this->neighbours(cut.plan, step);
    if (static_cast<Index>(plans.size()) > trialsLeft || execution.cancelled())
    {
      break;
    }
    trialsLeft -= static_cast<Index>(plans.size());
    std::vector<TriedCut> tried = this->tryAll(plans, longest, execution);
    if (!tried.empty() && tried.front().score > (1.0 + leastProgress) * cut.score)
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

std::vector<CutPlan> CutSearch::neighbours(const CutPlan& plan, double step) const
{
  std::vector<CutPlan> plans;
  const BoundaryRuler& ruler = this->Piece.ruler();
  const auto addMoved = [&](double base, double end) {
    CutPlan moved = plan;
    moved.base = ruler.moved(plan.base, base);
    moved.end = plan.type == CurveType::Seam ? ruler.moved(plan.end, end) : plan.end;
    if (this->Piece.worth(moved.base) > 0.0)
    {
      plans.push_back(moved);
    }
  };
  const bool along = plan.role == MirrorRole::Along;
  for (double by : { step, -step })
  {
    if (!along)
    {
      addMoved(by, 0.0);
    }
    if (plan.type == CurveType::Seam && plan.role != MirrorRole::Across && !along)
    {
      addMoved(0.0, by);
      addMoved(by, by);
      addMoved(by, -by);
    }
  }
  if (plan.type == CurveType::Dart)
  {
    const Point3 ahead = (plan.tip - this->Piece.baseOf(plan)).normalized();
    const Point3 aside = this->Piece.normalNear(plan.tip).cross(ahead);
    for (double by : { step, -step })
    {
      for (const Point3& direction : { ahead, aside })
      {
        CutPlan moved = plan;
        const Point3 tip = plan.tip + by * direction;
        if (along)
        {
          moved.tip = this->Piece.onto(this->Piece.mirror()->projected(tip));
        }
        else
        {
          moved.tip = this->Piece.onto(tip);
        }
        plans.push_back(moved);
      }
    }
  }
  return plans;
}
}
