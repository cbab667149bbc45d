// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/PieceNetwork.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening::pattern
{
namespace
{
constexpr double sameStop = 1.0;   ///< of a stop and the image of another, millimetres
constexpr double leastPart = 1e-6; ///< of an interval

/// Takes the ends of intervals away whose place follows from others, since the curve is the mirror
/// image of another, or of itself.
void leaveWhatFollows(const FairStretch& one, FairStretch& other)
{
  const bool own = &one == &other;
  std::vector<double> images; // of ends of intervals
  std::vector<FairInterval> left;
  const auto keep = [&](const FairInterval& interval) {
    left.push_back(interval);
    if (own)
    {
      images.push_back(other.length() - interval.end);
    }
  };
  for (std::size_t k = 0; !own && k + 1 < one.intervals.size(); ++k)
  {
    images.push_back((1.0 - one.intervals[k].end / one.length()) * other.length());
  }
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < other.intervals.size(); ++k)
  {
    const double end = other.intervals[k].end;
    length += other.intervals[k].length;
    const auto isHere = [end](double image) { return std::abs(image - end) < sameStop; };
    const bool follows =
      (own && isHere(other.length() / 2.0)) || std::any_of(images.begin(), images.end(), isHere);
    if (!follows && !other.straight)
    {
      keep({ end, length });
      length = 0.0;
    }
  }
  left.push_back({ other.length(), length + other.intervals.back().length, !own });
  other.intervals = std::move(left);
}

/// Adds an interval in parts between hooks, since what hangs on the curve does so at its length.
void addInterval(const PlannedInterval& interval, double start, FairStretch& stretch)
{
  const double length = interval.end - interval.start;
  double from = interval.start - start;
  const double to = interval.end - start;
  const auto add = [&](double end) {
    stretch.intervals.push_back({ end, interval.length * (end - from) / length });
    from = end;
  };
  for (const FairHook& hook : stretch.hooks)
  {
    if (hook.at > from + leastPart * length && hook.at < to - leastPart * length)
    {
      add(hook.at);
    }
  }
  add(to);
}
}

PieceNetwork::PieceNetwork(const DrawingSource& all, const BorderChains& chains,
  const std::vector<PlannedChain>& plan, std::size_t piece, const OutlineMirror& mirror,
  double& work)
  : All(all)
  , Chains(chains)
  , Plan(plan)
{
  this->Network.work = &work;
  for (std::size_t c = 0; c < plan.size(); ++c)
  {
    if (chains.chains()[c].piece != piece)
    {
      continue;
    }
    for (const PlannedStretch& stretch : plan[c].stretches)
    {
      if (stretch.form == StretchForm::Raw)
      {
        this->addEdges(c, stretch);
      }
      else
      {
        this->add(c, stretch);
      }
    }
  }
  this->addMirror(mirror);
}

void PieceNetwork::addMirror(const OutlineMirror& mirror)
{
  this->Network.mirror.at = mirror.axis.at;
  this->Network.mirror.along = mirror.axis.along;
  for (const MirroredStretches& pair : mirror.stretches)
  {
    const std::vector<PlannedStretch>& stretches = this->Plan[mirror.chain].stretches;
    const std::size_t one = this->indexOf(mirror.chain, stretches[pair.one].firstPoint);
    const std::size_t other = this->indexOf(mirror.chain, stretches[pair.other].firstPoint);
    leaveWhatFollows(this->Network.stretches[one], this->Network.stretches[other]);
    this->Network.mirror.stretches.push_back({ one, other });
  }
}

std::size_t PieceNetwork::nodeAt(Index point)
{
  const auto [entry, isNew] = this->Nodes.emplace(point, this->Network.nodes.size());
  if (isNew)
  {
    this->Network.nodes.push_back(this->All.at(point));
  }
  return entry->second;
}

void PieceNetwork::add(std::size_t c, const PlannedStretch& planned)
{
  const BorderChain& chain = this->Chains.chains()[c];
  FairStretch stretch;
  const Origin origin{ c, planned.firstPoint, chain.arc[planned.firstPoint] };
  stretch.from = this->nodeAt(chain.point(planned.firstPoint));
  stretch.to = this->nodeAt(chain.point(planned.lastPoint));
  stretch.smoothEnds = planned.smoothEnds;
  stretch.straight = planned.form == StretchForm::Straight;
  for (std::size_t k = planned.firstPoint + 1; k < planned.lastPoint; ++k)
  {
    const Index v = chain.point(k);
    stretch.arc.push_back(chain.arc[k] - origin.start);
    stretch.points.push_back(this->All.at(v));
    stretch.weights.push_back(planned.weights[k - planned.firstPoint]);
    if (this->Chains.chainsAt(v) > 1)
    {
      stretch.hooks.push_back({ stretch.arc.back(), this->nodeAt(v) });
    }
  }
  stretch.endWeights = { planned.weights.front(), planned.weights.back() };
  for (const double arc : planned.breaks)
  {
    stretch.breaks.push_back(arc - origin.start);
  }
  for (std::size_t k = planned.firstInterval; k < planned.endInterval; ++k)
  {
    addInterval(this->Plan[c].intervals[k], origin.start, stretch);
  }
  this->Network.stretches.push_back(std::move(stretch));
  this->Origins.push_back(origin);
}

void PieceNetwork::addEdges(std::size_t c, const PlannedStretch& planned)
{
  const BorderChain& chain = this->Chains.chains()[c];
  for (std::size_t k = planned.firstPoint; k < planned.lastPoint; ++k)
  {
    FairStretch stretch;
    const double length = chain.arc[k + 1] - chain.arc[k];
    stretch.from = this->nodeAt(chain.point(k));
    stretch.to = this->nodeAt(chain.point(k + 1));
    stretch.straight = true;
    stretch.breaks = { 0.0, length };
    stretch.intervals = { { length, length } };
    this->Network.stretches.push_back(std::move(stretch));
    this->Origins.push_back({ c, k, chain.arc[k] });
  }
}

std::size_t PieceNetwork::indexOf(std::size_t chain, std::size_t firstPoint) const
{
  const auto found = std::find_if(this->Origins.begin(), this->Origins.end(),
    [&](const Origin& origin) { return origin.chain == chain && origin.firstPoint == firstPoint; });
  return static_cast<std::size_t>(found - this->Origins.begin());
}

void PieceNetwork::take(const FairCurves& curves, std::vector<std::vector<FairSpan>>& spans,
  std::vector<std::vector<double>>& deviation) const
{
  for (const Origin& origin : this->Origins)
  {
    spans[origin.chain].clear();
    deviation[origin.chain].assign(this->Chains.chains()[origin.chain].arc.size(), 0.0);
  }
  for (std::size_t s = 0; s < this->Origins.size(); ++s)
  {
    const Origin& origin = this->Origins[s];
    for (FairSpan span : curves.spans[s])
    {
      span.from += origin.start;
      span.to += origin.start;
      spans[origin.chain].push_back(span);
    }
    for (std::size_t k = 0; k < curves.deviation[s].size(); ++k)
    {
      double& off = deviation[origin.chain][origin.firstPoint + k];
      off = std::max(off, curves.deviation[s][k]);
    }
  }
}
}
