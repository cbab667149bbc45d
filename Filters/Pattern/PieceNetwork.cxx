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
  Origin origin;
  origin.chain = c;
  origin.start = chain.arc[planned.firstPoint];
  stretch.from = this->nodeAt(chain.point(planned.firstPoint));
  stretch.to = this->nodeAt(chain.point(planned.lastPoint));
  stretch.smoothEnds = planned.smoothEnds;
  stretch.straight = planned.form == StretchForm::Straight;
  for (std::size_t k = planned.firstPoint + 1; k < planned.lastPoint; ++k)
  {
    const Index v = chain.point(k);
    stretch.arc.push_back(chain.arc[k] - origin.start);
    stretch.points.push_back(this->All.at(v));
    if (this->Chains.chainsAt(v) > 1)
    {
      stretch.hooks.push_back({ stretch.arc.back(), this->nodeAt(v) });
    }
  }
  for (std::size_t k = planned.firstInterval; k < planned.endInterval; ++k)
  {
    const PlannedInterval& interval = this->Plan[c].intervals[k];
    stretch.intervals.push_back({ interval.end - origin.start, interval.length, interval.spans,
      interval.partner[0] != PlannedInterval::none });
    origin.intervals.push_back(k);
  }
  this->Network.stretches.push_back(std::move(stretch));
  this->Origins.push_back(std::move(origin));
}

void PieceNetwork::addEdges(std::size_t c, const PlannedStretch& planned)
{
  const BorderChain& chain = this->Chains.chains()[c];
  for (std::size_t k = planned.firstPoint; k < planned.lastPoint; ++k)
  {
    FairStretch stretch;
    Origin origin;
    origin.chain = c;
    origin.start = chain.arc[k];
    stretch.from = this->nodeAt(chain.point(k));
    stretch.to = this->nodeAt(chain.point(k + 1));
    stretch.straight = true;
    for (std::size_t i = planned.firstInterval; i < planned.endInterval; ++i)
    {
      const PlannedInterval& interval = this->Plan[c].intervals[i];
      const double start = std::max(interval.start, chain.arc[k]);
      const double end = std::min(interval.end, chain.arc[k + 1]);
      if (end > start)
      {
        stretch.intervals.push_back({ end - origin.start, end - start, 1, false });
        origin.intervals.push_back(i);
      }
    }
    this->Network.stretches.push_back(std::move(stretch));
    this->Origins.push_back(std::move(origin));
  }
}

void PieceNetwork::take(const FairCurves& curves, std::vector<std::vector<FairSpan>>& spans,
  std::vector<std::vector<double>>& deviation) const
{
  for (const Origin& origin : this->Origins)
  {
    spans[origin.chain].clear();
    deviation[origin.chain].assign(this->Plan[origin.chain].intervals.size(), 0.0);
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
    for (std::size_t k = 0; k < origin.intervals.size(); ++k)
    {
      double& off = deviation[origin.chain][origin.intervals[k]];
      off = std::max(off, curves.deviation[s][k]);
    }
  }
}
}
}
