// SPDX-License-Identifier: BSD-3-Clause
#include "FairFit.h"

#include "FairTrial.h"
#include "FairWeights.h"
#include "PieceNetwork.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr int rounds = 24;
constexpr int emphases = 5;                           ///< in a row, of a plan
constexpr std::array<double, 2> ofTrial{ 0.99, 0.9 }; ///< of the tolerance
constexpr double nearly = 1.3;                        ///< of a tolerance: more emphasis may help
constexpr int tolerated = 3;                          ///< how often
constexpr double progress = 0.9; ///< what more breaks must make of what is too far
constexpr int smoothings = 6;
constexpr double widerWave = 1.6;
constexpr double sparing = 0.5; ///< of the tolerance, what may be spent on smoothness alone
}

FairFit::FairFit(
  const DrawingSource& all, const BorderChains& chains, const std::vector<double>& shares)
  : All(all)
  , Chains(chains)
  , Plan(planFairBorders(all, chains, shares))
  , Spans(this->Plan.size())
  , Deviation(this->Plan.size())
  , Held(all.loops.size())
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
  for (std::size_t p = 0; p < pieces; ++p)
  {
    for (int round = 0; round < rounds; ++round)
    {
      const bool last = round + 4 > rounds;
      if (this->solveEvenly(p, emphases) ? !this->refine(p, last)
                                         : !this->halveSpans(p) && !this->loosen(p))
      {
        break;
      }
    }
    if (this->settle(p))
    {
      for (const double share : ofTrial)
      {
        this->coarsen(p, share);
      }
      this->smooth(p);
    }
  }
}

bool FairFit::settle(std::size_t piece)
{
  bool solved = this->solvePiece(piece);
  while (solved && !this->keepsTolerances(piece))
  {
    this->leaveBad(piece);
    solved = this->solvePiece(piece);
  }
  if (!solved)
  {
    this->leave(piece);
    this->drawEdges(piece);
  }
  return solved;
}

bool FairFit::isOf(std::size_t chain, std::size_t piece) const
{
  return this->Chains.chains()[chain].piece == piece;
}

bool FairFit::solvePiece(std::size_t piece)
{
  const PieceNetwork network(this->All, this->Chains, this->Plan, piece);
  FairNetwork held = network.network();
  held.held = this->Held[piece];
  const FairCurves curves = solveFairNetwork(held, this->Wave[piece]);
  if (curves.converged)
  {
    network.take(curves, this->Spans, this->Deviation);
  }
  return curves.converged;
}

std::vector<FairFit::Place> FairFit::placesOf(std::size_t piece, StretchForm form) const
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

double FairFit::toleranceAt(const Place& place, std::size_t point) const
{
  const PlannedChain& chain = this->Plan[place.chain];
  const PlannedStretch& stretch = chain.stretches[place.stretch];
  const double arc = this->Chains.chains()[place.chain].arc[point];
  std::size_t k = stretch.firstInterval;
  while (k + 1 < stretch.endInterval && arc > chain.intervals[k].end)
  {
    ++k;
  }
  return chain.intervals[k].tolerance;
}

double FairFit::excess(const Place& place) const
{
  const PlannedStretch& stretch = this->Plan[place.chain].stretches[place.stretch];
  double most = 0.0;
  for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
  {
    most = std::max(most, this->Deviation[place.chain][k] / this->toleranceAt(place, k));
  }
  return most;
}

bool FairFit::emphasizeStretch(const Place& place)
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

bool FairFit::solveEvenly(std::size_t piece, int times)
{
  bool solved = this->solvePiece(piece);
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
    solved = this->solvePiece(piece);
  }
  return solved;
}

bool FairFit::refine(std::size_t piece, bool last)
{
  bool changed = false;
  // What is straight may be off because of the splines that it meets.
  for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
  {
    for (const Place& place : this->placesOf(piece, form))
    {
      changed = (this->excess(place) > 1.0 && this->refineStretch(place, last)) || changed;
    }
    if (changed)
    {
      break;
    }
  }
  return changed;
}

bool FairFit::refineStretch(const Place& place, bool last)
{
  PlannedStretch& stretch = this->at(place);
  if (stretch.form == StretchForm::Straight)
  {
    stretch.form = StretchForm::Spline; // lengths beside it have moved it
  }
  else if (last || !this->addBreaks(place))
  {
    this->leave(place);
  }
  return true;
}

void FairFit::leave(const Place& place)
{
  PlannedStretch& stretch = this->at(place);
  LeftStretch left{ place.chain, stretch.firstPoint, 0.0, 0.0 };
  for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
  {
    const double off = this->Deviation[place.chain][k];
    const double tolerance = this->toleranceAt(place, k);
    if (off > tolerance && off > left.needed)
    {
      left.needed = off;
      left.tolerance = tolerance;
    }
  }
  stretch.form = StretchForm::Raw;
  this->Left.push_back(left);
}

void FairFit::leaveBad(std::size_t piece)
{
  for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
  {
    for (const Place& place : this->placesOf(piece, form))
    {
      if (this->excess(place) > 1.0)
      {
        this->leave(place);
      }
    }
  }
}

bool FairFit::addBreaks(const Place& place)
{
  PlannedStretch& stretch = this->at(place);
  // Where a curve as long as its edges must be so far off, no number of breaks helps.
  const double excess = this->excess(place);
  stretch.futile = excess > progress * stretch.excess ? stretch.futile + 1 : 0;
  stretch.excess = std::min(stretch.excess, excess);
  if (stretch.futile > 1)
  {
    return excess < nearly && stretch.futile < 2 + tolerated;
  }
  const std::vector<double>& arc = this->Chains.chains()[place.chain].arc;
  std::vector<double> breaks{ stretch.breaks.front() };
  std::size_t point = stretch.firstPoint;
  for (std::size_t k = 0; k + 1 < stretch.breaks.size(); ++k)
  {
    const double end = stretch.breaks[k + 1];
    std::size_t points = 0;
    bool off = false;
    for (; point <= stretch.lastPoint && arc[point] <= end; ++point)
    {
      off = off || this->Deviation[place.chain][point] > this->toleranceAt(place, point);
      points += arc[point] > stretch.breaks[k] && arc[point] < end ? 1 : 0;
    }
    if (off && points > 0)
    {
      breaks.push_back((stretch.breaks[k] + end) / 2.0);
    }
    breaks.push_back(end);
  }
  const bool added = breaks.size() > stretch.breaks.size();
  stretch.breaks = std::move(breaks);
  std::fill(stretch.weights.begin(), stretch.weights.end(), 1.0);
  return added;
}

void FairFit::coarsen(std::size_t piece, double share)
{
  const PieceNetwork network(this->All, this->Chains, this->Plan, piece);
  const std::vector<PlannedChain> before = this->Plan;
  const Points2 heldBefore = this->Held[piece];
  if (heldBefore.empty())
  {
    // Nodes stay from here on, so that the stretches are each by itself.
    this->Held[piece] = solveFairNetwork(network.network(), this->Wave[piece]).nodes;
  }
  std::vector<std::pair<Place, PlannedStretch>> changed; // with what they were
  for (const Place& place : this->placesOf(piece, StretchForm::Spline))
  {
    PlannedStretch& stretch = this->at(place);
    std::vector<double> tolerances;
    for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
    {
      tolerances.push_back(share * this->toleranceAt(place, k));
    }
    FairTrial trial(network.network(), network.indexOf(place.chain, stretch.firstPoint),
      this->Held[piece], tolerances, this->Wave[piece]);
    if (!trial.join(stretch.leastSpans()))
    {
      continue;
    }
    changed.emplace_back(place, stretch);
    const double start = stretch.breaks.front();
    const double end = stretch.breaks.back();
    stretch.breaks.clear();
    for (const double at : trial.breaks())
    {
      stretch.breaks.push_back(start + at);
    }
    stretch.breaks.back() = end;
    stretch.weights = trial.weights();
  }
  // What all of them together do not keep is taken back.
  while (!changed.empty())
  {
    const bool solved = this->solveEvenly(piece, emphases);
    if (solved && this->keepsTolerances(piece))
    {
      return;
    }
    const auto isGood = [&](const auto& one) { return solved && this->excess(one.first) <= 1.0; };
    auto bad = std::partition(changed.begin(), changed.end(), isGood);
    bad = bad == changed.end() ? changed.begin() : bad; // what they have moved is off
    for (auto one = bad; one != changed.end(); ++one)
    {
      this->at(one->first) = one->second;
    }
    changed.erase(bad, changed.end());
  }
  this->Plan = before;
  this->Held[piece] = heldBefore;
  this->solvePiece(piece);
}

bool FairFit::keepsTolerances(std::size_t piece) const
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

bool FairFit::halveSpans(std::size_t piece)
{
  bool halved = false;
  for (const Place& place : this->placesOf(piece, StretchForm::Spline))
  {
    PlannedStretch& stretch = this->at(place);
    std::fill(stretch.weights.begin(), stretch.weights.end(), 1.0);
    if (2 * stretch.spans() > stretch.edges())
    {
      continue;
    }
    std::vector<double> breaks{ stretch.breaks.front() };
    for (std::size_t k = 1; k < stretch.breaks.size(); ++k)
    {
      breaks.push_back((stretch.breaks[k - 1] + stretch.breaks[k]) / 2.0);
      breaks.push_back(stretch.breaks[k]);
    }
    stretch.breaks = std::move(breaks);
    halved = true;
  }
  return halved;
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
  const std::vector<Place> splines = this->placesOf(piece, StretchForm::Spline);
  double most = splines.empty() ? std::numeric_limits<double>::infinity() : 0.0;
  for (const std::vector<Place>& places : { splines, this->placesOf(piece, StretchForm::Straight) })
  {
    for (const Place& place : places)
    {
      most = std::max(most, this->excess(place));
    }
  }
  return most;
}
}
}
