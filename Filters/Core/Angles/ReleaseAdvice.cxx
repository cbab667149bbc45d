// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/ReleaseAdvice.h"

#include "Base/Types.h"

#include "Angles/AngleSolver.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Most releases that are tried of either kind: each costs a flattening of the piece.
constexpr std::size_t maxTried = 3;

bool isShaped(const std::vector<FeatureCurve>& curves, const Indices& released, Index curve)
{
  return curves[curve].type == CurveType::Key &&
    !std::binary_search(released.begin(), released.end(), curve);
}

/// Per key curve what its shape alone costs: half the squared changes of its angles.
std::vector<double> shapeCosts(const WireNetwork& network, const std::vector<FeatureCurve>& curves,
  const Indices& released, const std::vector<double>& theta)
{
  std::vector<double> cost(curves.size(), 0.0);
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    const Index curve = network.edges[network.edge[i]].curve;
    if (curve != none && isShaped(curves, released, curve))
    {
      const double change = theta[i] - network.alpha[i];
      cost[curve] += 0.5 * change * change;
    }
  }
  return cost;
}

void sortByMagnitude(const std::vector<double>& value, Indices& ids)
{
  std::stable_sort(ids.begin(), ids.end(),
    [&](Index a, Index b) { return std::abs(value[a]) > std::abs(value[b]); });
}

bool better(const ReleaseTrial& a, const ReleaseTrial& b, ReleaseMeasure measure)
{
  if (a.solved != b.solved || !a.solved)
  {
    return a.solved && !b.solved;
  }
  if (measure == ReleaseMeasure::Objective)
  {
    return a.objective < b.objective;
  }
  const bool flipsA = a.homogeneity <= 0.0;
  const bool flipsB = b.homogeneity <= 0.0;
  return flipsA != flipsB ? flipsB : a.areaError < b.areaError;
}
}

ReleaseAdvice adviseRelease(const WireNetwork& network, const std::vector<FeatureCurve>& curves,
  const AngleSolution& solution)
{
  ReleaseAdvice advice;
  advice.sensitivity.assign(curves.size(), 0.0);
  if (solution.multiplierX.size() != static_cast<std::size_t>(network.loopCount()))
  {
    return advice;
  }
  const std::vector<double> byEdge = lengthSensitivity(network, solution);
  std::vector<char> inside(curves.size(), 0);
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    if (edge.curve != none && edge.otherSide != none)
    {
      inside[edge.curve] = 1;
      advice.sensitivity[edge.curve] += byEdge[e] * solution.length[e];
    }
  }
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (inside[c])
    {
      advice.ranking.push_back(static_cast<Index>(c));
    }
  }
  sortByMagnitude(advice.sensitivity, advice.ranking);
  rankReleases({}, ReleaseMeasure::Objective, advice);
  return advice;
}

Indices releaseCandidates(const ReleaseAdvice& advice, const WireNetwork& network,
  const std::vector<FeatureCurve>& curves, Indices keys, const Indices& released,
  const AngleSolution& solution)
{
  Indices candidates;
  for (std::size_t k = 0; k < advice.ranking.size() && candidates.size() < maxTried; ++k)
  {
    if (!isShaped(curves, released, advice.ranking[k]))
    {
      candidates.push_back(advice.ranking[k]);
    }
  }
  eraseIf(keys, [&](Index key) { return !isShaped(curves, released, key); });
  sortByMagnitude(shapeCosts(network, curves, released, solution.theta), keys);
  keys.resize(std::min(keys.size(), maxTried));
  candidates.insert(candidates.end(), keys.begin(), keys.end());
  return candidates;
}

void rankReleases(
  const std::vector<ReleaseTrial>& trials, ReleaseMeasure measure, ReleaseAdvice& advice)
{
  const auto trialOf = [&trials](Index curve) {
    const auto trial = std::find_if(trials.begin(), trials.end(),
      [curve](const ReleaseTrial& candidate) { return candidate.curve == curve; });
    return trial == trials.end() ? ReleaseTrial{ curve } : *trial;
  };
  for (const ReleaseTrial& trial : trials)
  {
    if (std::find(advice.ranking.begin(), advice.ranking.end(), trial.curve) ==
      advice.ranking.end())
    {
      advice.ranking.push_back(trial.curve);
    }
  }
  std::stable_sort(advice.ranking.begin(), advice.ranking.end(),
    [&](Index a, Index b) { return better(trialOf(a), trialOf(b), measure); });
  advice.trials.clear();
  for (Index curve : advice.ranking)
  {
    advice.trials.push_back(trialOf(curve));
  }
}
}
