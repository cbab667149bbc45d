// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairSolution.h"

#include "Fairing/FairPlan.h"
#include "Fairing/FairTrial.h"
#include "Fairing/OutlineMirror.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
FairSolution::FairSolution(
  const DrawingSource& all, const BorderChains& chains, const FairLimits& limits)
  : All(all)
  , Chains(chains)
  , Plan(planFairBorders(all, chains, limits.shares))
  , Spans(this->Plan.size())
  , Deviation(this->Plan.size())
  , Work(*limits.work)
{
  for (std::size_t p = 0; p < all.loops.size(); ++p)
  {
    this->Mirrors.push_back(
      limits.mirrored[p] ? findOutlineMirror(all, chains, this->Plan, p) : OutlineMirror());
    if (limits.mirroredWithin[p])
    {
      findInnerMirror(all, chains, this->Plan, this->Mirrors.back());
      this->mirrorPlan(p);
      const PieceNetwork network = this->networkOf(p);
      for (const MirroredStretches& pair : network.unlike())
      {
        this->dropImage(pair.one);
      }
    }
    this->mirrorPlan(p);
    double length = 0.0;
    std::size_t edges = 0;
    for (const BorderChain& chain : chains.chains())
    {
      length += chain.piece == p ? chain.length() : 0.0;
      edges += chain.piece == p ? chain.edges() : 0;
    }
    this->Wave.push_back(length / static_cast<double>(std::max<std::size_t>(edges, 1)));
  }
  equalizeMirroredLengths(this->Mirrors, this->Plan);
}

std::optional<FairSolution::Place> FairSolution::imageOf(const Place& place) const
{
  for (const OutlineMirror& mirror : this->Mirrors)
  {
    for (const MirroredStretches& pair : mirror.stretches)
    {
      if (pair.has(place))
      {
        return pair.one == place ? pair.other : pair.one;
      }
    }
  }
  return std::nullopt;
}

void FairSolution::dropImage(const Place& place)
{
  for (OutlineMirror& mirror : this->Mirrors)
  {
    const auto found = std::find_if(mirror.stretches.begin(), mirror.stretches.end(),
      [&place](const MirroredStretches& pair) { return pair.has(place); });
    if (found == mirror.stretches.end())
    {
      continue;
    }
    for (const Place& one : { found->one, found->other })
    {
      PlannedChain& chain = this->Plan[one.chain];
      const PlannedStretch& stretch = chain.stretches[one.stretch];
      for (std::size_t k = stretch.firstInterval; k < stretch.endInterval; ++k)
      {
        chain.intervals[k].length = chain.intervals[k].end - chain.intervals[k].start;
      }
    }
    mirror.stretches.erase(found);
  }
}

void FairSolution::mirrorPlan(std::size_t piece)
{
  pattern::mirrorPlan(this->Mirrors[piece], this->Plan);
}

void FairSolution::placeIntervals(std::size_t piece)
{
  for (const MirroredStretches& pair : this->Mirrors[piece].stretches)
  {
    this->placeIntervals(pair.one);
    if (!pair.own())
    {
      this->placeIntervals(pair.other);
    }
  }
}

void FairSolution::placeIntervals(const Place& place)
{
  PlannedChain& chain = this->Plan[place.chain];
  const PlannedStretch& stretch = this->at(place);
  PlannedInterval whole;
  whole.places = { stretch.breaks.front(), stretch.breaks.back() };
  const IntervalCurve curve(this->Spans[place.chain], whole);
  double length = 0.0;
  for (std::size_t k = stretch.firstInterval; k + 1 < stretch.endInterval; ++k)
  {
    length += chain.intervals[k].length;
    chain.intervals[k].places[1] = chain.intervals[k + 1].places[0] =
      curve.placeAt(length / curve.length());
  }
}

bool FairSolution::isOf(std::size_t chain, std::size_t piece) const
{
  return this->Chains.chains()[chain].piece == piece;
}

std::vector<FairSolution::Place> FairSolution::placesOf(std::size_t piece, StretchForm form) const
{
  std::vector<Place> places;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    for (std::size_t s = 0; this->isOf(c, piece) && s < this->Plan[c].stretches.size(); ++s)
    {
      if (this->Plan[c].stretches[s].form == form)
      {
        places.push_back({ c, s });
      }
    }
  }
  return places;
}

double FairSolution::toleranceAt(const Place& place, std::size_t point) const
{
  const PlannedChain& chain = this->Plan[place.chain];
  const PlannedStretch& stretch = chain.stretches[place.stretch];
  const double arc = this->Chains.chains()[place.chain].arc[point];
  const auto first = chain.intervals.begin() + static_cast<std::ptrdiff_t>(stretch.firstInterval);
  const auto last = chain.intervals.begin() + static_cast<std::ptrdiff_t>(stretch.endInterval) - 1;
  return std::partition_point(first, last, [arc](const PlannedInterval& interval) {
    return interval.end < arc;
  })->tolerance;
}

double FairSolution::excess(const Place& place) const
{
  const PlannedStretch& stretch = this->Plan[place.chain].stretches[place.stretch];
  double most = 0.0;
  for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
  {
    most = std::max(most, this->Deviation[place.chain][k] / this->toleranceAt(place, k));
  }
  return most;
}

bool FairSolution::keepsTolerances(std::size_t piece) const
{
  for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
  {
    for (const Place& place : this->placesOf(piece, form))
    {
      if (this->excess(place) > 1.0)
      {
        return false;
      }
    }
  }
  return true;
}

double FairSolution::largestDeviation(std::size_t piece) const
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

PieceNetwork FairSolution::networkOf(std::size_t piece) const
{
  return { this->All, this->Chains, this->Plan, piece, this->Mirrors[piece], this->Work[piece] };
}

bool FairSolution::solve(std::size_t piece)
{
  const PieceNetwork network = this->networkOf(piece);
  const FairCurves curves = solveFairNetwork(network.network(), this->Wave[piece]);
  if (curves.converged)
  {
    network.take(curves, this->Spans, this->Deviation);
  }
  return curves.converged;
}

bool FairSolution::solveEvenly(std::size_t piece, int times)
{
  bool solved = this->solve(piece);
  for (int k = 0; solved && k < times; ++k)
  {
    bool any = false;
    for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
    {
      for (const Place& place : this->placesOf(piece, form))
      {
        any = this->emphasizeStretch(place) || any;
      }
    }
    if (!any)
    {
      break;
    }
    solved = this->solve(piece);
  }
  return solved;
}

bool FairSolution::emphasizeStretch(const Place& place)
{
  PlannedStretch& stretch = this->at(place);
  std::vector<double> shares;
  for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
  {
    shares.push_back(this->Deviation[place.chain][k] / this->toleranceAt(place, k));
  }
  const bool isOff = *std::max_element(shares.begin(), shares.end()) > 1.0;
  if (isOff)
  {
    emphasize(shares, stretch.weights);
  }
  return isOff;
}

void FairSolution::take(const Place& place, const FairTrial& trial, std::size_t part)
{
  PlannedStretch& stretch = this->at(place);
  const double start = stretch.breaks.front();
  const double end = stretch.breaks.back();
  std::vector<FairSpan>& spans = this->Spans[place.chain];
  const auto isOfIt = [start, end](const FairSpan& span) {
    const double middle = (span.from + span.to) / 2.0;
    return start < middle && middle < end;
  };
  auto at = std::find_if(spans.begin(), spans.end(), isOfIt);
  at = spans.erase(at, std::find_if_not(at, spans.end(), isOfIt));
  std::vector<FairSpan> own = trial.spans(part);
  for (FairSpan& span : own)
  {
    span.from += start;
    span.to += start;
  }
  own.back().to = end;
  spans.insert(at, own.begin(), own.end());
  stretch.breaks.clear();
  for (const FairSpan& span : own)
  {
    stretch.breaks.push_back(span.from);
  }
  stretch.breaks.push_back(end);
  stretch.weights = trial.weights(part);
  // Its ends are of the stretches beside it as well, and stay.
  const std::vector<double>& deviation = trial.deviation(part);
  std::copy(deviation.begin() + 1, deviation.end() - 1,
    this->Deviation[place.chain].begin() + static_cast<std::ptrdiff_t>(stretch.firstPoint) + 1);
}

void FairSolution::drawEdges(std::size_t piece)
{
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    if (chain.piece != piece)
    {
      continue;
    }
    this->Spans[c].clear();
    this->Deviation[c].assign(chain.arc.size(), 0.0);
    for (std::size_t k = 0; k < chain.edges(); ++k)
    {
      const Point2 from = this->All.at(chain.point(k));
      const Point2 way = this->All.at(chain.point(k + 1)) - from;
      this->Spans[c].push_back({ chain.arc[k], chain.arc[k + 1],
        { from, from + way / 3.0, from + 2.0 * way / 3.0, from + way } });
    }
  }
}
}
}
