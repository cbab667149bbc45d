// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairFit.h"

#include "Fairing/FairTrial.h"
#include "Fairing/PieceNetwork.h"

#include <algorithm>
#include <utility>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr int rounds = 24;
constexpr int emphases = 5;      ///< in a row, of a plan
constexpr double nearly = 1.3;   ///< of a tolerance: more emphasis may help
constexpr int tolerated = 3;     ///< how often
constexpr double progress = 0.9; ///< what more breaks must make of what is too far
}

FairFit::FairFit(const DrawingSource& all, const BorderChains& chains, const FairLimits& limits)
  : Chains(chains)
  , Now(all, chains, limits)
  , Solved(all.loops.size(), true)
  , Unmirrored(all.loops.size())
{
  for (std::size_t p = 0; p < this->Solved.size(); ++p)
  {
    this->fitPiece(p);
    this->Now.placeIntervals(p);
  }
}

void FairFit::fitPiece(std::size_t p)
{
  for (int round = 0; round < rounds && !this->Unmirrored[p]; ++round)
  {
    const bool last = round + 4 > rounds;
    if (this->Now.solveEvenly(p, emphases) ? !this->refine(p, last)
                                           : !this->halveSpans(p) && !this->loosen(p))
    {
      break;
    }
    this->Now.mirrorPlan(p);
  }
  if (!this->Unmirrored[p] && this->settle(p))
  {
    this->coarsen(p);
  }
  if (this->Unmirrored[p])
  {
    this->leave(p);
    this->Now.drawEdges(p);
  }
}

bool FairFit::settle(std::size_t piece)
{
  bool solved = this->Now.solve(piece);
  while (solved && !this->Now.keepsTolerances(piece))
  {
    this->leaveBad(piece);
    if (this->Unmirrored[piece])
    {
      return false;
    }
    solved = this->Now.solve(piece);
  }
  if (!solved && this->Now.mirror(piece).found())
  {
    this->Unmirrored[piece].emplace();
  }
  if (!solved)
  {
    this->leave(piece);
    this->Now.drawEdges(piece);
  }
  return solved;
}

bool FairFit::refine(std::size_t piece, bool last)
{
  bool changed = false;
  // What is straight may be off because of the splines that it meets.
  for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
  {
    for (const Place& place : this->Now.placesOf(piece, form))
    {
      changed = (this->Now.excess(place) > 1.0 && this->refineStretch(place, last)) || changed;
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
  PlannedStretch& stretch = this->Now.at(place);
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
  PlannedStretch& stretch = this->Now.at(place);
  LeftStretch left{ place.chain, stretch.firstPoint, 0.0, 0.0 };
  for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
  {
    const double off = this->Now.deviationAt(place, k);
    const double tolerance = this->Now.toleranceAt(place, k);
    if (off > tolerance && off > left.needed)
    {
      left.needed = off;
      left.tolerance = tolerance;
    }
  }
  const std::size_t piece = this->Chains.chains()[place.chain].piece;
  if (this->Now.imageOf(place) && place.chain == this->Now.mirror(piece).chain)
  {
    this->Unmirrored[piece] = left;
    return;
  }
  this->Now.dropImage(place);
  stretch.form = StretchForm::Raw;
  this->Left.push_back(left);
}

void FairFit::leaveBad(std::size_t piece)
{
  for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
  {
    for (const Place& place : this->Now.placesOf(piece, form))
    {
      if (this->Now.excess(place) > 1.0)
      {
        this->leave(place);
      }
    }
  }
}

bool FairFit::addBreaks(const Place& place)
{
  PlannedStretch& stretch = this->Now.at(place);
  // Where a curve as long as its edges must be so far off, no number of breaks helps.
  const double excess = this->Now.excess(place);
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
      off = off || this->Now.deviationAt(place, point) > this->Now.toleranceAt(place, point);
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

void FairFit::coarsen(std::size_t piece)
{
  // Nodes stay from here on, so that the stretches are each by itself.
  const PieceNetwork network = this->Now.networkOf(piece);
  const FairCurves curves = solveFairNetwork(network.network(), this->Now.wave(piece));
  if (!curves.converged)
  {
    return; // the work is used up
  }
  for (const Place& place : this->Now.placesOf(piece, StretchForm::Spline))
  {
    const std::optional<Place> image = this->Now.imageOf(place);
    const auto key = [](const Place& one) { return std::make_pair(one.chain, one.stretch); };
    if (image && key(*image) < key(place))
    {
      continue; // with the other
    }
    std::vector<Place> places{ place };
    if (image && !(*image == place))
    {
      places.push_back(*image);
    }
    std::vector<FairTrial::Part> parts;
    for (const Place& one : places)
    {
      const PlannedStretch& stretch = this->Now.at(one);
      FairTrial::Part& part = parts.emplace_back();
      part.stretch = network.indexOf(one.chain, stretch.firstPoint);
      for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
      {
        part.tolerances.push_back(this->Now.toleranceAt(one, k));
      }
    }
    FairTrial trial(network.network(), parts, curves.nodes, this->Now.wave(piece));
    if (trial.findFewest(this->Now.at(place).leastSpans()))
    {
      trial.smooth();
      for (std::size_t k = 0; k < places.size(); ++k)
      {
        this->Now.take(places[k], trial, k);
      }
    }
  }
}

bool FairFit::halveSpans(std::size_t piece)
{
  bool halved = false;
  for (const Place& place : this->Now.placesOf(piece, StretchForm::Spline))
  {
    PlannedStretch& stretch = this->Now.at(place);
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
  for (std::size_t c = 0; c < this->Now.plan().size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    for (PlannedStretch& stretch : this->Now.plan()[c].stretches)
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
  for (std::size_t c = 0; c < this->Now.plan().size(); ++c)
  {
    for (PlannedStretch& stretch : this->Now.plan()[c].stretches)
    {
      stretch.form = this->Now.isOf(c, piece) ? StretchForm::Raw : stretch.form;
    }
  }
}
}
}
