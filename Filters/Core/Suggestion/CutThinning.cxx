// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutThinning.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// Cuts a line back to a share of its length, from its end.
void trim(SuggestedCurve& cut, double share)
{
  Points3 kept{ cut.curve.points.front() };
  double left = share * cut.length;
  for (std::size_t k = 1; k < cut.curve.points.size() && left > 0.0; ++k)
  {
    const Point3 step = cut.curve.points[k] - kept.back();
    const double length = step.norm();
    kept.push_back(
      length > left ? Point3(kept.back() + left / length * step) : cut.curve.points[k]);
    left -= length;
  }
  cut.curve.points = std::move(kept);
  cut.length *= share;
}
}

std::vector<Polyline> linesOf(const std::vector<SuggestedCurve>& cuts)
{
  std::vector<Polyline> lines;
  for (const SuggestedCurve& cut : cuts)
  {
    lines.push_back(cut.curve);
  }
  return lines;
}

std::vector<SuggestedCurve> withShare(
  const std::vector<SuggestedCurve>& cuts, std::size_t which, double share)
{
  std::vector<SuggestedCurve> result;
  Indices place(cuts.size(), none);
  for (std::size_t k = 0; k < cuts.size(); ++k)
  {
    const bool chosen = k == which || cuts[k].mirrorOf == static_cast<Index>(which);
    if (chosen && share == 0.0)
    {
      continue;
    }
    place[k] = static_cast<Index>(result.size());
    result.push_back(cuts[k]);
    if (chosen)
    {
      trim(result.back(), share);
    }
    if (cuts[k].mirrorOf != none)
    {
      result.back().mirrorOf = place[cuts[k].mirrorOf];
    }
  }
  return result;
}

void thinCuts(const CutTrials& trials, double bound, std::vector<SuggestedCurve>& cuts,
  TrialOutcome& now, TrialBudget& budget, const Execution& execution)
{
  bool thinned = now.valid;
  while (thinned && !cuts.empty() && !budget.spent() && !execution.cancelled())
  {
    thinned = false;
    std::vector<std::vector<SuggestedCurve>> fewer;
    std::vector<std::vector<Polyline>> lines;
    for (std::size_t k = 0; k < cuts.size(); ++k)
    {
      const bool dart = cuts[k].curve.type == CurveType::Dart;
      for (double share : { 0.0, 1.0 / 3.0, 2.0 / 3.0 })
      {
        if (cuts[k].mirrorOf == none && (share == 0.0 || dart))
        {
          fewer.push_back(withShare(cuts, k, share));
          lines.push_back(linesOf(fewer.back()));
        }
      }
    }
    const std::vector<TrialOutcome> outcomes = trials.runAll(lines, execution);
    budget.pay(outcomes);
    std::size_t best = lines.size();
    for (std::size_t k = 0; k < lines.size(); ++k)
    {
      const TrialOutcome& outcome = outcomes[k];
      if (outcome.soundAfter(now) && outcome.strainP95 <= bound &&
        (best == lines.size() || outcome.cutLength() < outcomes[best].cutLength()))
      {
        best = k;
      }
    }
    if (best < lines.size())
    {
      cuts = std::move(fewer[best]);
      now = outcomes[best];
      thinned = true;
    }
  }
}
}
