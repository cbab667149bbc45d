// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/ChartTrials.h"

#include "Sparse/LinearSolver.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace flattening
{
/// Two sums of the bits of all coordinates and corners (FNV-1a, from two starts).
ChartTrials::Key ChartTrials::keyOf(const TriangleMesh& chart)
{
  Key key{ 0xcbf29ce484222325U, 0x84222325cbf29ce4U };
  const auto add = [&key](std::uint64_t bits) {
    for (std::uint64_t& sum : key)
    {
      sum = (sum ^ bits) * 0x100000001b3U;
      sum ^= sum >> 29U;
    }
  };
  for (const Point3& point : chart.points())
  {
    for (double coordinate : point)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof bits);
      add(bits);
    }
  }
  for (const Triangle& triangle : chart.triangles())
  {
    for (Index corner : triangle)
    {
      add(static_cast<std::uint64_t>(corner));
    }
  }
  return key;
}

ChartTrials::Result ChartTrials::flattened(const TriangleMesh& chart, double bound, double most,
  const std::vector<FlatCorners>& start, const Execution& execution) const
{
  const double steps =
    this->MostSteps * factorizationWork(static_cast<double>(chart.triangleCount()));
  Result result;
  const auto flatten = [&](const FlatteningOptions& options, const std::vector<FlatCorners>& from) {
    TrialBudget budget(std::min(most - result.work, steps));
    CutTrials trials(chart, {}, {}, options);
    trials.startFrom(from);
    const CutTrials::Trial trial = trials.trial({}, budget, execution);
    const TrialOutcome& outcome = trial.outcome;
    result.sound = outcome.valid && outcome.flipped == 0 && outcome.overlaps == 0;
    result.strain = outcome.valid ? outcome.strainP95 : std::numeric_limits<double>::infinity();
    result.waste = outcome.waste;
    result.work += budget.work();
    result.corners =
      result.sound && this->InParts ? cornersOf(trial.flat) : std::vector<FlatCorners>();
  };
  if (this->InParts && std::isfinite(bound))
  {
    FlatteningOptions enough = this->Flattening;
    enough.enoughStrain = bound;
    flatten(enough, start);
    result.upTo = result.keeps(bound) ? 0.0 : bound;
  }
  if (result.upTo == 0.0)
  {
    flatten(this->Flattening, {});
  }
  return result;
}

std::vector<ChartTrials::Result> ChartTrials::run(
  const std::vector<std::vector<TriangleMesh>>& sets, double bound, TrialBudget& budget,
  const Execution& execution, const std::vector<FlatCorners>& start)
{
  std::vector<Result> results(sets.size());
  const Execution inner = execution.nestedExecution();
  for (std::size_t first = 0; first < sets.size() && !budget.spent(); first += triedTogether)
  {
    const double left = budget.left();
    const std::size_t last = std::min(sets.size(), first + triedTogether);
    std::vector<std::vector<std::pair<Key, Result>>> fresh(last - first);
    execution.forEachTask(static_cast<Index>(last - first), [&](Index k) {
      Result all;
      all.sound = true;
      all.strain = 0.0;
      for (const TriangleMesh& chart : sets[first + k])
      {
        const Key key = keyOf(chart);
        const auto known = this->Known.find(key);
        const bool isKnown = known != this->Known.end() && known->second.holdsFor(bound);
        const Result one =
          isKnown ? known->second : this->flattened(chart, bound, left, start, inner);
        if (!isKnown)
        {
          fresh[k].emplace_back(key, one);
          all.work += one.work;
        }
        all.sound = all.sound && one.sound;
        all.strain = std::max(all.strain, one.strain);
        all.waste += one.waste;
        all.corners = one.corners;
        if (!all.keeps(bound))
        {
          break;
        }
      }
      results[first + k] = all;
    });
    for (std::size_t k = first; k < last && !execution.cancelled(); ++k)
    {
      if (results[k].work > 0.0)
      {
        budget.pay(results[k].work);
      }
      for (auto& [key, one] : fresh[k - first])
      {
        if (one.work < left) // with more it may come out otherwise
        {
          one.corners = one.keeps(bound) ? std::move(one.corners) : std::vector<FlatCorners>();
          this->Known.insert_or_assign(key, std::move(one));
        }
      }
    }
  }
  return results;
}
}
