// SPDX-License-Identifier: BSD-3-Clause
#include "FairTrial.h"

#include "FairWeights.h"

#include <algorithm>
#include <utility>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr int work = 400;             ///< solutions
constexpr int emphasesOfDivision = 6; ///< of one division
constexpr double hopeless = 1.5;      ///< tolerances, after some emphases
}

FairTrial::FairTrial(const FairNetwork& network, std::size_t stretch, const Points2& nodes,
  std::vector<double> tolerances, double wave)
  : Tolerances(std::move(tolerances))
  , Wave(wave)
  , Left(work)
{
  FairStretch one = network.stretches[stretch];
  this->Weights.push_back(one.endWeights[0]);
  this->Weights.insert(this->Weights.end(), one.weights.begin(), one.weights.end());
  this->Weights.push_back(one.endWeights[1]);
  const auto take = [&](std::size_t node) {
    this->One.nodes.push_back(nodes[node]);
    return this->One.nodes.size() - 1;
  };
  const bool ring = one.from == one.to;
  one.from = take(one.from);
  one.to = ring ? one.from : take(one.to);
  for (FairHook& hook : one.hooks)
  {
    hook.node = take(hook.node);
  }
  this->One.held = this->One.nodes;
  this->One.stretches.push_back(std::move(one));
}

bool FairTrial::join(std::size_t leastSpans)
{
  bool any = false;
  std::size_t start = 1;
  for (bool joined = true; joined && this->Left > 0;)
  {
    joined = false;
    const std::vector<double> all = this->breaks();
    const std::size_t within = all.size() - 2;
    for (std::size_t n = 0; !joined && n < within && all.size() > leastSpans + 1; ++n)
    {
      // On from where the last one was: what was needed there is needed still.
      const std::size_t k = 1 + (start - 1 + n) % within;
      std::vector<double> fewer = all;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      joined = this->take(fewer);
      if (!joined && k < within)
      {
        fewer[k] = (all[k] + all[k + 1]) / 2.0;
        joined = this->take(fewer);
      }
      start = joined ? k : start;
    }
    any = any || joined;
  }
  return any;
}

bool FairTrial::take(const std::vector<double>& breaks)
{
  const std::vector<double> before = std::exchange(this->stretch().breaks, breaks);
  const std::vector<double> weights = this->Weights;
  if (this->fits())
  {
    return true;
  }
  this->stretch().breaks = before;
  this->Weights = weights;
  return false;
}

bool FairTrial::fits()
{
  FairStretch& stretch = this->stretch();
  for (int k = 0; k<emphasesOfDivision&& this->Left> 0; ++k, --this->Left)
  {
    stretch.weights.assign(this->Weights.begin() + 1, this->Weights.end() - 1);
    const FairCurves curves = solveFairNetwork(this->One, this->Wave);
    if (!curves.converged)
    {
      return false;
    }
    std::vector<double> shares(this->Tolerances.size(), 0.0);
    for (std::size_t p = 1; p + 1 < shares.size(); ++p)
    {
      shares[p] = curves.deviation[0][p] / this->Tolerances[p];
    }
    const double most = *std::max_element(shares.begin(), shares.end());
    if (most <= 1.0 || (k > 1 && most > hopeless))
    {
      return most <= 1.0;
    }
    emphasize(shares, this->Weights);
  }
  return false;
}
}
}
