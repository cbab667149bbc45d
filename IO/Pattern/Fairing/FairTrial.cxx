// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairTrial.h"

#include "Fairing/OutlineMirror.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace flattening::pattern
{
namespace
{
constexpr double leastFactor = 0.2;
constexpr double leastWeight = 0.01;
}

void emphasize(const std::vector<double>& shares, std::vector<double>& weights)
{
  const double most = *std::max_element(shares.begin(), shares.end());
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    weights[k] *= leastFactor + shares[k] / most;
  }
  const double mean =
    std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  for (double& weight : weights)
  {
    weight = std::max(weight / mean, leastWeight);
  }
}

namespace
{
constexpr int work = 1000;             ///< solutions
constexpr int emphasesOfDivision = 12; ///< of one division
constexpr double hopeless = 1.5;       ///< tolerances, after some emphases
constexpr double atMiddle = 1e-6;      ///< of a stretch, from its middle
constexpr int roundsOfBalance = 8;     ///< of a number of curves
constexpr double leastOff = 0.1;       ///< of a curve in what its length is chosen by
constexpr double balancing = 0.4;      ///< power of how far off it is
constexpr int smoothings = 6;
constexpr double widerWave = 1.6;
constexpr double sparing = 0.5; ///< of the tolerance, what may be spent on smoothness alone

double largestOf(const std::vector<std::vector<double>>& shares)
{
  double most = 0.0;
  for (const std::vector<double>& own : shares)
  {
    most = std::max(most, *std::max_element(own.begin(), own.end()));
  }
  return most;
}
}

FairTrial::FairTrial(
  const FairNetwork& network, const std::vector<Part>& parts, const Points2& nodes, double wave)
  : Wave(wave)
  , Left(work)
{
  const auto take = [&](std::size_t node) {
    this->Network.nodes.push_back(nodes[node]);
    return this->Network.nodes.size() - 1;
  };
  for (const Part& part : parts)
  {
    FairStretch one = network.stretches[part.stretch];
    std::vector<double>& weights = this->Weights.emplace_back();
    weights.push_back(one.endWeights[0]);
    weights.insert(weights.end(), one.weights.begin(), one.weights.end());
    weights.push_back(one.endWeights[1]);
    const bool ring = one.from == one.to;
    one.from = take(one.from);
    one.to = ring ? one.from : take(one.to);
    for (FairHook& hook : one.hooks)
    {
      hook.node = take(hook.node);
    }
    this->Arcs.push_back(one.arc);
    this->Tolerances.push_back(part.tolerances);
    this->Network.stretches.push_back(std::move(one));
  }
  this->Network.held = true;
  this->Network.work = network.work;
  this->Network.mirror = network.mirror;
  this->Network.mirror.stretches.clear();
  for (const FairImages& pair : network.mirror.stretches)
  {
    if (pair.one == parts.front().stretch)
    {
      this->Network.mirror.stretches.push_back({ 0, parts.size() - 1 });
    }
  }
}

bool FairTrial::isOwnImage() const
{
  return !this->Network.mirror.stretches.empty() && this->Network.stretches.size() == 1;
}

std::vector<double> FairTrial::freeOf(std::vector<double> breaks) const
{
  if (this->isOwnImage())
  {
    const double end = breaks.back();
    breaks.resize((breaks.size() + 1) / 2); // up to the one in the middle, if there is one
    breaks.push_back(end);
  }
  return breaks;
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

bool FairTrial::findFewest(std::size_t leastSpans)
{
  if (!this->fits())
  {
    return false;
  }
  // As if what so many curves do more of them did as well.
  std::size_t low = leastSpans;
  while (low < this->breaks().size() - 1 && this->Left > 0)
  {
    const std::size_t middle = (low + this->breaks().size() - 2) / 2;
    low = this->divide(middle) ? low : middle + 1;
  }
  this->join(leastSpans);
  return true;
}

bool FairTrial::divide(std::size_t spans)
{
  const std::vector<double> before = this->breaks();
  const Lists weights = this->Weights;
  // From the breaks that there are: where more were needed more will be.
  std::vector<double> breaks;
  for (std::size_t k = 0; k < spans; ++k)
  {
    const double at =
      static_cast<double>(k) * static_cast<double>(before.size() - 1) / static_cast<double>(spans);
    const auto whole = static_cast<std::size_t>(at);
    const double part = at - static_cast<double>(whole);
    breaks.push_back(before[whole] + part * (before[whole + 1] - before[whole]));
  }
  breaks.push_back(before.back());
  for (int round = 0; this->Left > 0 && round < roundsOfBalance; ++round)
  {
    this->setBreaks(this->freeOf(breaks));
    for (std::vector<double>& own : this->Weights)
    {
      std::fill(own.begin(), own.end(), 1.0);
    }
    if (this->fits())
    {
      return true;
    }
    if (spans == 1 || !this->balance(breaks))
    {
      break;
    }
  }
  this->setBreaks(this->freeOf(before));
  this->Weights = weights;
  return false;
}

double FairTrial::mostBetween(double start, double end) const
{
  const double whole = this->breaks().back();
  double most = leastOff;
  for (std::size_t s = 0; s < this->Shares.size(); ++s)
  {
    const FairStretch& stretch = this->Network.stretches[s];
    for (std::size_t p = 0; p < stretch.arc.size(); ++p)
    {
      const double image = (1.0 - stretch.arc[p] / stretch.length()) * whole;
      const bool within = s == 0 && stretch.arc[p] >= start && stretch.arc[p] <= end;
      const bool imageWithin = (s > 0 || this->isOwnImage()) && image >= start && image <= end;
      most = within || imageWithin ? std::max(most, this->Shares[s][p + 1]) : most;
    }
  }
  return most;
}

bool FairTrial::balance(std::vector<double>& breaks) const
{
  if (this->Shares.empty())
  {
    return false;
  }
  std::vector<double> lengths;
  double total = 0.0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    const double most = this->mostBetween(breaks[k], breaks[k + 1]);
    lengths.push_back((breaks[k + 1] - breaks[k]) * std::pow(most, -balancing));
    total += lengths.back();
  }
  double at = 0.0;
  for (std::size_t k = 0; k + 2 < breaks.size(); ++k)
  {
    at += lengths[k] / total * breaks.back();
    breaks[k + 1] = at;
  }
  return true;
}

void FairTrial::join(std::size_t leastSpans)
{
  std::size_t start = 1;
  for (bool joined = true; joined && this->Left > 0;)
  {
    joined = false;
    const std::vector<double> all = this->freeOf(this->breaks());
    const std::size_t within = all.size() - 2;
    for (std::size_t n = 0; !joined && n<within&& this->breaks().size()> leastSpans + 1; ++n)
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
  }
}

bool FairTrial::take(const std::vector<double>& freeBreaks)
{
  const std::vector<double> before = this->freeOf(this->breaks());
  const Lists weights = this->Weights;
  this->setBreaks(freeBreaks);
  if (this->fits())
  {
    return true;
  }
  this->setBreaks(before);
  this->Weights = weights;
  return false;
}

bool FairTrial::solve(FairCurves& curves)
{
  for (std::size_t s = 0; s < this->Weights.size(); ++s)
  {
    const std::vector<double>& own = this->Weights[s];
    this->Network.stretches[s].weights.assign(own.begin() + 1, own.end() - 1);
  }
  --this->Left;
  curves = solveFairNetwork(this->Network, this->Wave);
  this->Shares.clear();
  for (std::size_t s = 0; curves.converged && s < this->Tolerances.size(); ++s)
  {
    std::vector<double>& own = this->Shares.emplace_back();
    for (std::size_t p = 0; p < this->Tolerances[s].size(); ++p)
    {
      own.push_back(curves.deviation[s][p] / this->Tolerances[s][p]);
    }
  }
  return curves.converged;
}

bool FairTrial::fits()
{
  for (std::size_t s = 0; s < this->Arcs.size(); ++s)
  {
    this->Network.stretches[s].arc = this->Arcs[s];
  }
  for (int k = 0; this->Left > 0 && k < emphasesOfDivision; ++k)
  {
    FairCurves curves;
    if (!this->solve(curves))
    {
      return false;
    }
    // The ends are where they are.
    Lists shares = this->Shares;
    for (std::vector<double>& own : shares)
    {
      own.front() = own.back() = 0.0;
    }
    const double most = largestOf(shares);
    if (most <= 1.0)
    {
      this->Found = std::move(curves);
      for (std::size_t s = 0; s < this->Arcs.size(); ++s)
      {
        this->Arcs[s] = this->Network.stretches[s].arc;
      }
      return true;
    }
    if (k > 1 && most > hopeless)
    {
      return false;
    }
    for (std::size_t s = 0; s < shares.size(); ++s)
    {
      if (*std::max_element(shares[s].begin(), shares[s].end()) > 0.0)
      {
        emphasize(shares[s], this->Weights[s]);
      }
    }
    this->follow(curves.nearest);
  }
  return false;
}

void FairTrial::follow(const Lists& nearest)
{
  for (std::size_t s = 0; s < nearest.size(); ++s)
  {
    FairStretch& one = this->Network.stretches[s];
    for (std::size_t p = 0; p < one.arc.size(); ++p)
    {
      const bool isHook = std::any_of(one.hooks.begin(), one.hooks.end(),
        [&](const FairHook& hook) { return hook.at == one.arc[p]; });
      const double before = p == 0 ? 0.0 : one.arc[p - 1];
      const double after = p + 1 == one.arc.size() ? one.length() : one.arc[p + 1];
      if (!isHook && before < nearest[s][p] && nearest[s][p] < after)
      {
        one.arc[p] = nearest[s][p];
      }
    }
  }
}

void FairTrial::smooth()
{
  for (int k = 0; k < smoothings; ++k)
  {
    this->Wave *= widerWave;
    FairCurves curves;
    if (!this->solve(curves) || largestOf(this->Shares) > sparing)
    {
      break;
    }
    this->Found = std::move(curves);
  }
}
}
