// SPDX-License-Identifier: BSD-3-Clause
#include "FairTrial.h"

#include "FairWeights.h"
#include "OutlineMirror.h"

#include <algorithm>
#include <map>
#include <utility>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr int work = 400;             ///< solutions
constexpr int emphasesOfDivision = 6; ///< of one division
constexpr double atMiddle = 1e-6;     ///< of a stretch, from its middle
constexpr double hopeless = 1.5;      ///< tolerances, after some emphases
}

FairTrial::FairTrial(
  const FairNetwork& network, const std::vector<Part>& parts, const Points2& nodes, double wave)
  : Wave(wave)
  , Left(work)
{
  std::map<std::size_t, std::size_t> known;
  const auto take = [&](std::size_t node) {
    const auto [entry, isNew] = known.emplace(node, this->Network.nodes.size());
    if (isNew)
    {
      this->Network.nodes.push_back(nodes[node]);
    }
    return entry->second;
  };
  for (const Part& part : parts)
  {
    FairStretch one = network.stretches[part.stretch];
    std::vector<double>& weights = this->Weights.emplace_back();
    weights.push_back(one.endWeights[0]);
    weights.insert(weights.end(), one.weights.begin(), one.weights.end());
    weights.push_back(one.endWeights[1]);
    one.from = take(one.from);
    one.to = take(one.to);
    for (FairHook& hook : one.hooks)
    {
      hook.node = take(hook.node);
    }
    this->Tolerances.push_back(part.tolerances);
    this->Network.stretches.push_back(std::move(one));
  }
  this->Network.held = this->Network.nodes;
  this->Network.mirror = network.mirror;
  this->Network.mirror.stretches.clear();
  for (const auto& [one, other] : network.mirror.stretches)
  {
    if (one == parts.front().stretch)
    {
      this->Network.mirror.stretches.push_back({ 0, parts.size() - 1 });
    }
  }
}

bool FairTrial::isOwnImage() const
{
  return !this->Network.mirror.stretches.empty() && this->Network.stretches.size() == 1;
}

std::vector<double> FairTrial::freeBreaks() const
{
  std::vector<double> all = this->breaks(0);
  if (this->isOwnImage())
  {
    const double end = all.back();
    all.resize((all.size() + 1) / 2); // up to the one in the middle, if there is one
    all.push_back(end);
  }
  return all;
}

void FairTrial::setBreaks(const std::vector<double>& freeBreaks)
{
  std::vector<double>& all = this->Network.stretches.front().breaks;
  all = freeBreaks;
  if (this->isOwnImage())
  {
    const double end = all.back();
    all.pop_back();
    for (std::size_t k = all.size(); k-- > 0;)
    {
      if (2.0 * all[k] < (1.0 - atMiddle) * end)
      {
        all.push_back(end - all[k]);
      }
    }
    all.back() = end;
  }
  for (std::size_t s = 1; s < this->Network.stretches.size(); ++s)
  {
    std::vector<double>& image = this->Network.stretches[s].breaks;
    image = mirroredBreaks(all, image.front(), image.back());
  }
}

bool FairTrial::join(std::size_t leastSpans)
{
  bool any = false;
  std::size_t start = 1;
  for (bool joined = true; joined && this->Left > 0;)
  {
    joined = false;
    const std::vector<double> all = this->freeBreaks();
    const std::size_t within = all.size() - 2;
    for (std::size_t n = 0; !joined && n<within&& this->breaks(0).size()> leastSpans + 1; ++n)
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

bool FairTrial::take(const std::vector<double>& freeBreaks)
{
  const std::vector<double> before = this->freeBreaks();
  const std::vector<std::vector<double>> weights = this->Weights;
  this->setBreaks(freeBreaks);
  if (this->fits())
  {
    return true;
  }
  this->setBreaks(before);
  this->Weights = weights;
  return false;
}

bool FairTrial::fits()
{
  for (int k = 0; k<emphasesOfDivision&& this->Left> 0; ++k, --this->Left)
  {
    for (std::size_t s = 0; s < this->Weights.size(); ++s)
    {
      this->Network.stretches[s].weights.assign(
        this->Weights[s].begin() + 1, this->Weights[s].end() - 1);
    }
    const FairCurves curves = solveFairNetwork(this->Network, this->Wave);
    if (!curves.converged)
    {
      return false;
    }
    double most = 0.0;
    std::vector<std::vector<double>> shares;
    for (std::size_t s = 0; s < this->Weights.size(); ++s)
    {
      std::vector<double>& own = shares.emplace_back(this->Tolerances[s].size(), 0.0);
      for (std::size_t p = 1; p + 1 < own.size(); ++p)
      {
        own[p] = curves.deviation[s][p] / this->Tolerances[s][p];
      }
      most = std::max(most, *std::max_element(own.begin(), own.end()));
    }
    if (most <= 1.0 || (k > 1 && most > hopeless))
    {
      return most <= 1.0;
    }
    for (std::size_t s = 0; s < this->Weights.size(); ++s)
    {
      if (*std::max_element(shares[s].begin(), shares[s].end()) > 0.0)
      {
        emphasize(shares[s], this->Weights[s]);
      }
    }
  }
  return false;
}
}
}
