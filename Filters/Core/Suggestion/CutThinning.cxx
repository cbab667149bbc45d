// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutThinning.h"

#include <algorithm>
#include <array>

namespace flattening
{
namespace
{
/// What is tried to be left of a cut, first by much, and once none of that holds by less.
constexpr std::array<std::array<double, 3>, 3> keptShares{ { { 0.0, 1.0 / 3.0, 2.0 / 3.0 },
  { 0.8, 0.9, 0.95 }, { 0.97, 0.98, 0.99 } } };
}

Points3 shortened(const Points3& line, double length)
{
  Points3 kept{ line.front() };
  double left = length;
  for (std::size_t k = 1; k < line.size() && left > 0.0; ++k)
  {
    const Point3 step = line[k] - kept.back();
    const double edge = step.norm();
    kept.push_back(edge > left ? Point3(kept.back() + left / edge * step) : line[k]);
    left -= edge;
  }
  return kept;
}

double priceOf(const std::vector<SuggestedCurve>& cuts, double size)
{
  double price = cutPrice * static_cast<double>(cuts.size());
  for (const SuggestedCurve& cut : cuts)
  {
    price += cut.length / size;
  }
  return price;
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

void previewCuts(const std::vector<SuggestedCurve>& cuts, const Execution& execution)
{
  if (execution.preview)
  {
    std::vector<Points3> lines;
    for (const SuggestedCurve& cut : cuts)
    {
      lines.push_back(cut.curve.points);
    }
    execution.preview(lines);
  }
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
      result.back().length *= share;
      result.back().curve.points = shortened(cuts[k].curve.points, result.back().length);
    }
    if (cuts[k].mirrorOf != none)
    {
      result.back().mirrorOf = place[cuts[k].mirrorOf];
    }
  }
  return result;
}

void thinCuts(const CutTrials& trials, double bound, double least,
  std::vector<SuggestedCurve>& cuts, TrialOutcome& now, TrialBudget& budget,
  const Execution& execution)
{
  std::size_t level = now.valid ? 0 : keptShares.size();
  while (level < keptShares.size() && !cuts.empty() && !budget.spent() && !execution.cancelled())
  {
    std::vector<std::vector<SuggestedCurve>> fewer;
    std::vector<std::vector<Polyline>> lines;
    for (std::size_t k = 0; k < cuts.size(); ++k)
    {
      const bool dart = cuts[k].curve.type == CurveType::Dart;
      for (double share : keptShares[level])
      {
        if (cuts[k].mirrorOf == none && (share == 0.0 || (dart && share * cuts[k].length >= least)))
        {
          fewer.push_back(withShare(cuts, k, share));
          lines.push_back(linesOf(fewer.back()));
        }
      }
    }
    const std::vector<TrialOutcome> outcomes = trials.runAll(lines, budget, execution);
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
    }
    else
    {
      ++level;
    }
  }
}
}
