// SPDX-License-Identifier: BSD-3-Clause
#include "PieceNetwork.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
PieceNetwork::PieceNetwork(const DrawingSource& all, const BorderChains& chains,
  const std::vector<PlannedChain>& plan, std::size_t piece)
  : All(all)
  , Chains(chains)
  , Plan(plan)
{
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
    const PlannedInterval& interval = this->Plan[c].intervals[k];
    stretch.intervals.push_back({ interval.end - origin.start, interval.length });
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
}
