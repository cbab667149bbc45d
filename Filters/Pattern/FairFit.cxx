// SPDX-License-Identifier: BSD-3-Clause
#include "FairFit.h"

#include "PieceNetwork.h"

#include <algorithm>
#include <limits>
#include <set>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr int rounds = 12;
constexpr std::size_t work = 100000; ///< trials of fewer spans, times edges of the mesh
constexpr int smoothings = 6;
constexpr double widerWave = 1.6;
constexpr double sparing = 0.5; ///< of the tolerance, what may be spent on smoothness alone

int more(const PlannedInterval& interval)
{
  return std::min(interval.most, interval.spans + std::max(1, interval.spans / 2));
}

int fewer(const PlannedInterval& interval)
{
  return std::max(interval.least, 7 * interval.spans / 10);
}
}

FairFit::FairFit(
  const DrawingSource& all, const BorderChains& chains, const std::vector<double>& shares)
  : All(all)
  , Chains(chains)
  , Plan(planFairBorders(all, chains, shares))
  , Spans(this->Plan.size())
  , Deviation(this->Plan.size())
  , Solved(all.loops.size(), true)
{
  const std::size_t pieces = all.loops.size();
  for (std::size_t p = 0; p < pieces; ++p)
  {
    double length = 0.0;
    std::size_t edges = 0;
    for (const BorderChain& chain : chains.chains())
    {
      length += chain.piece == p ? chain.length() : 0.0;
      edges += chain.piece == p ? chain.edges() : 0;
    }
    this->Wave.push_back(length / static_cast<double>(std::max<std::size_t>(edges, 1)));
  }
  for (int round = 0; round < rounds; ++round)
  {
    agreeOnSpans(this->Plan);
    bool changed = false;
    for (std::size_t p = 0; p < pieces; ++p)
    {
      if (!this->solvePiece(p))
      {
        if (!this->loosen(p))
        {
          this->leave(p);
        }
        changed = true;
        continue;
      }
      changed = this->refine(p, round + 4 > rounds) || changed;
    }
    if (!changed)
    {
      break;
    }
  }
  for (std::size_t p = 0; p < pieces; ++p)
  {
    if (!this->solvePiece(p))
    {
      this->leave(p);
      this->drawEdges(p);
    }
  }
  this->coarsen();
  for (std::size_t p = 0; p < pieces; ++p)
  {
    this->smooth(p);
  }
}

bool FairFit::isOf(std::size_t chain, std::size_t piece) const
{
  return this->Chains.chains()[chain].piece == piece;
}

bool FairFit::solvePiece(std::size_t piece)
{
  const PieceNetwork network(this->All, this->Chains, this->Plan, piece);
  const FairCurves curves = solveFairNetwork(network.network(), this->Wave[piece]);
  if (curves.converged)
  {
    network.take(curves, this->Spans, this->Deviation);
  }
  return curves.converged;
}

bool FairFit::refine(std::size_t piece, bool last)
{
  bool changed = false;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    if (this->isOf(c, piece))
    {
      for (PlannedStretch& stretch : this->Plan[c].stretches)
      {
        changed = this->refineStretch(c, stretch, last) || changed;
      }
    }
  }
  return changed;
}

bool FairFit::refineStretch(std::size_t c, PlannedStretch& stretch, bool last)
{
  if (stretch.form == StretchForm::Raw)
  {
    return false;
  }
  LeftStretch worst{ c, stretch.firstPoint, 0.0, 0.0 };
  bool refined = false;
  for (std::size_t k = stretch.firstInterval; k < stretch.endInterval; ++k)
  {
    const double off = this->Deviation[c][k];
    PlannedInterval& interval = this->Plan[c].intervals[k];
    if (off > interval.tolerance)
    {
      worst.tolerance = off > worst.needed ? interval.tolerance : worst.tolerance;
      worst.needed = std::max(worst.needed, off);
      if (stretch.form == StretchForm::Spline && interval.spans < interval.most && !last)
      {
        interval.spans = more(interval);
        refined = true;
      }
    }
  }
  if (refined || worst.needed == 0.0)
  {
    return refined;
  }
  if (stretch.form == StretchForm::Straight)
  {
    stretch.form = StretchForm::Spline; // lengths beside it have moved it
  }
  else
  {
    stretch.form = StretchForm::Raw;
    this->Left.push_back(worst);
  }
  return true;
}

void FairFit::coarsen()
{
  std::size_t edges = 1;
  for (const BorderChain& chain : this->Chains.chains())
  {
    edges += chain.edges();
  }
  std::size_t left = work / edges + 1;
  for (bool kept = true; kept && left > 0; --left)
  {
    kept = this->tryFewer(this->reducible());
  }
  // From here on one interval after the other: each trial takes spans away or finds the least.
  for (std::vector<Place> places = this->reducible(); !places.empty() && left > 0;
       places = this->reducible())
  {
    for (std::size_t k = 0; k < places.size() && left > 0; ++k)
    {
      if (this->at(places[k]).spans > this->at(places[k]).least)
      {
        this->tryFewer({ places[k] });
        --left;
      }
    }
  }
}

std::vector<FairFit::Place> FairFit::reducible() const
{
  std::vector<Place> places;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    for (const PlannedStretch& stretch : this->Plan[c].stretches)
    {
      for (std::size_t k = stretch.firstInterval; k < stretch.endInterval; ++k)
      {
        const PlannedInterval& interval = this->Plan[c].intervals[k];
        if (stretch.form == StretchForm::Spline && interval.spans > interval.least)
        {
          places.push_back({ c, k });
        }
      }
    }
  }
  return places;
}

bool FairFit::tryFewer(const std::vector<Place>& places)
{
  if (places.empty())
  {
    return false;
  }
  const std::vector<PlannedChain> plan = this->Plan;
  const std::vector<std::vector<FairSpan>> spans = this->Spans;
  const std::vector<std::vector<double>> deviation = this->Deviation;
  std::set<std::size_t> pieces;
  for (const Place& place : places)
  {
    PlannedInterval& interval = this->at(place);
    interval.spans = fewer(plan[place.chain].intervals[place.interval]);
    pieces.insert(this->Chains.chains()[place.chain].piece);
    if (interval.partner[0] != PlannedInterval::none)
    {
      // Both sides have as many, so that they are divided alike.
      PlannedInterval& other = this->at({ interval.partner[0], interval.partner[1] });
      interval.least = other.least = std::max(interval.least, other.least);
      interval.spans = other.spans = std::max(interval.spans, other.least);
      pieces.insert(this->Chains.chains()[interval.partner[0]].piece);
    }
  }
  const bool keeps = std::all_of(pieces.begin(), pieces.end(),
    [this](std::size_t p) { return this->solvePiece(p) && this->keepsTolerances(p); });
  if (keeps)
  {
    return true;
  }
  const int tried = this->at(places.front()).spans;
  this->Plan = plan;
  this->Spans = spans;
  this->Deviation = deviation;
  if (places.size() == 1)
  {
    PlannedInterval& interval = this->at(places.front());
    interval.least = tried + 1;
    if (interval.partner[0] != PlannedInterval::none)
    {
      PlannedInterval& other = this->at({ interval.partner[0], interval.partner[1] });
      other.least = std::max(other.least, tried + 1);
    }
  }
  return false;
}

bool FairFit::keepsTolerances(std::size_t piece) const
{
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    for (const PlannedStretch& stretch : this->Plan[c].stretches)
    {
      for (std::size_t k = stretch.firstInterval; k < stretch.endInterval; ++k)
      {
        if (this->isOf(c, piece) && stretch.form != StretchForm::Raw &&
          this->Deviation[c][k] > this->Plan[c].intervals[k].tolerance)
        {
          return false;
        }
      }
    }
  }
  return true;
}

void FairFit::smooth(std::size_t piece)
{
  for (int k = 0; k < smoothings; ++k)
  {
    this->Wave[piece] *= widerWave;
    const auto spans = this->Spans;
    const auto deviation = this->Deviation;
    if (!this->solvePiece(piece) || this->largestShare(piece) > sparing)
    {
      this->Spans = spans;
      this->Deviation = deviation;
      break;
    }
  }
}

bool FairFit::loosen(std::size_t piece)
{
  bool loosened = false;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    for (PlannedStretch& stretch : this->Plan[c].stretches)
    {
      const double length = chain.arc[stretch.lastPoint] - chain.arc[stretch.firstPoint];
      if (chain.piece == piece && stretch.form == StretchForm::Straight &&
        stretch.bend > inexact * length)
      {
        stretch.form = StretchForm::Spline;
        loosened = true;
      }
    }
  }
  return loosened;
}

void FairFit::leave(std::size_t piece)
{
  this->Solved[piece] = false;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    for (PlannedStretch& stretch : this->Plan[c].stretches)
    {
      stretch.form = this->isOf(c, piece) ? StretchForm::Raw : stretch.form;
    }
  }
}

void FairFit::drawEdges(std::size_t piece)
{
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    if (chain.piece != piece)
    {
      continue;
    }
    this->Spans[c].clear();
    this->Deviation[c].assign(this->Plan[c].intervals.size(), 0.0);
    for (std::size_t k = 0; k < chain.edges(); ++k)
    {
      const Point2 from = this->All.at(chain.point(k));
      const Point2 way = this->All.at(chain.point(k + 1)) - from;
      this->Spans[c].push_back({ chain.arc[k], chain.arc[k + 1],
        { from, from + way / 3.0, from + 2.0 * way / 3.0, from + way } });
    }
  }
}

double FairFit::largestDeviation(std::size_t piece) const
{
  double most = 0.0;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    if (this->isOf(c, piece))
    {
      for (const double deviation : this->Deviation[c])
      {
        most = std::max(most, deviation);
      }
    }
  }
  return most;
}

double FairFit::largestShare(std::size_t piece) const
{
  double most = 0.0;
  double largest = 0.0; // tolerance, for what stays as it was
  for (const PlannedChain& chain : this->Plan)
  {
    for (const PlannedInterval& interval : chain.intervals)
    {
      largest = std::max(largest, interval.tolerance);
    }
  }
  if (largest == 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    for (std::size_t k = 0; this->isOf(c, piece) && k < this->Deviation[c].size(); ++k)
    {
      const double own = this->Plan[c].intervals[k].tolerance;
      most = std::max(most, this->Deviation[c][k] / (own > 0.0 ? own : largest));
    }
  }
  return most;
}
}
}
