// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairFit.h"

#include "Fairing/FairSolver.h"
#include "Fairing/FairTrial.h"
#include "Fairing/PieceNetwork.h"

#include <algorithm>
#include <utility>

namespace flattening::pattern
{
namespace
{
constexpr int rounds = 24;
constexpr int emphases = 5;      ///< in a row, of a plan
constexpr double nearly = 1.3;   ///< of a tolerance: more emphasis may help
constexpr int tolerated = 3;     ///< how often
constexpr double progress = 0.9; ///< what more breaks must make of what is too far

/// Fits piece by piece: a plan of all stretches, and the curves that are found for it.
class Fitting
{
public:
  /// Source and chains stay the caller's.
  Fitting(const DrawingSource& all, const BorderChains& chains, const FairLimits& limits)
    : All(all)
    , Chains(chains)
    , Work(*limits.work)
  {
    const std::size_t pieces = all.loops.size();
    this->Fit.plan = planFairBorders(all, chains, limits.shares);
    this->Fit.spans.resize(this->Fit.plan.size());
    this->Deviation.resize(this->Fit.plan.size());
    this->Fit.solved.assign(pieces, true);
    this->Fit.unmirrored.resize(pieces);
    for (std::size_t p = 0; p < pieces; ++p)
    {
      this->Fit.mirrors.push_back(
        limits.mirrored[p] ? findOutlineMirror(all, chains, this->Fit.plan, p) : OutlineMirror());
      mirrorPlan(this->Fit.mirrors.back(), this->Fit.plan);
      double length = 0.0;
      std::size_t edges = 0;
      for (const BorderChain& chain : chains.chains())
      {
        length += chain.piece == p ? chain.length() : 0.0;
        edges += chain.piece == p ? chain.edges() : 0;
      }
      this->Wave.push_back(length / static_cast<double>(std::max<std::size_t>(edges, 1)));
    }
    equalizeMirroredLengths(this->Fit.mirrors, this->Fit.plan);
  }

  FairFit run()
  {
    for (std::size_t p = 0; p < this->Fit.solved.size(); ++p)
    {
      this->fitPiece(p);
      this->placeIntervals(p);
      this->Fit.deviation.push_back(this->largestDeviation(p));
    }
    return std::move(this->Fit);
  }

private:
  void fitPiece(std::size_t p)
  {
    for (int round = 0; round < rounds && !this->Fit.unmirrored[p]; ++round)
    {
      const bool last = round + 4 > rounds;
      if (this->solveEvenly(p, emphases) ? !this->refine(p, last)
                                         : !this->halveSpans(p) && !this->loosen(p))
      {
        break;
      }
      mirrorPlan(this->Fit.mirrors[p], this->Fit.plan);
    }
    if (!this->Fit.unmirrored[p] && this->settle(p))
    {
      this->coarsen(p);
    }
    if (this->Fit.unmirrored[p])
    {
      this->leave(p);
      this->drawEdges(p);
    }
  }

  /// Leaves what does not keep its tolerance. \return whether there is a solution
  bool settle(std::size_t piece)
  {
    bool solved = this->solve(piece);
    while (solved && !this->keepsTolerances(piece))
    {
      this->leaveBad(piece);
      if (this->Fit.unmirrored[piece])
      {
        return false;
      }
      solved = this->solve(piece);
    }
    if (!solved && this->Fit.mirrors[piece].found())
    {
      this->Fit.unmirrored[piece].emplace();
    }
    if (!solved)
    {
      this->leave(piece);
      this->drawEdges(piece);
    }
    return solved;
  }

  /// Breaks where the tolerance is not kept, and the stretch as it was where they do not help.
  /// \param last nothing is tried any more
  bool refine(std::size_t piece, bool last)
  {
    bool changed = false;
    // What is straight may be off because of the splines that it meets.
    for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
    {
      for (const StretchPlace& place : this->placesOf(piece, form))
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

  bool refineStretch(const StretchPlace& place, bool last)
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

  /// Lets a stretch be as it was.
  void leave(const StretchPlace& place)
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
    const std::size_t piece = this->Chains.chains()[place.chain].piece;
    if (this->imageOf(place))
    {
      this->Fit.unmirrored[piece] = left;
      return;
    }
    stretch.form = StretchForm::Raw;
    this->Fit.left.push_back(left);
  }

  /// Lets all of the piece be as it was.
  void leave(std::size_t piece)
  {
    this->Fit.solved[piece] = false;
    for (std::size_t c = 0; c < this->Fit.plan.size(); ++c)
    {
      for (PlannedStretch& stretch : this->Fit.plan[c].stretches)
      {
        stretch.form = this->isOf(c, piece) ? StretchForm::Raw : stretch.form;
      }
    }
  }

  void leaveBad(std::size_t piece)
  {
    for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
    {
      for (const StretchPlace& place : this->placesOf(piece, form))
      {
        if (this->excess(place) > 1.0)
        {
          this->leave(place);
        }
      }
    }
  }

  bool addBreaks(const StretchPlace& place)
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

  /// Draws each stretch by fewer curves, where these keep the tolerances.
  void coarsen(std::size_t piece)
  {
    // Nodes stay from here on, so that the stretches are each by itself.
    const PieceNetwork network = this->networkOf(piece);
    const FairCurves curves = solveFairNetwork(network.network(), this->Wave[piece]);
    if (!curves.converged)
    {
      return; // the work is used up
    }
    for (const StretchPlace& place : this->placesOf(piece, StretchForm::Spline))
    {
      const std::optional<StretchPlace> image = this->imageOf(place);
      const auto key = [](const StretchPlace& one) {
        return std::make_pair(one.chain, one.stretch);
      };
      if (image && key(*image) < key(place))
      {
        continue; // with the other
      }
      std::vector<StretchPlace> places{ place };
      if (image && !(*image == place))
      {
        places.push_back(*image);
      }
      std::vector<FairTrial::Part> parts;
      for (const StretchPlace& one : places)
      {
        const PlannedStretch& stretch = this->at(one);
        FairTrial::Part& part = parts.emplace_back();
        part.stretch = network.indexOf(one.chain, stretch.firstPoint);
        for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
        {
          part.tolerances.push_back(this->toleranceAt(one, k));
        }
      }
      FairTrial trial(network.network(), parts, curves.nodes, this->Wave[piece]);
      if (trial.findFewest(this->at(place).leastSpans()))
      {
        trial.smooth();
        for (std::size_t k = 0; k < places.size(); ++k)
        {
          this->take(places[k], trial, k);
        }
      }
    }
  }

  /// Gives all splines of a piece twice as many curves, where they may have them.
  bool halveSpans(std::size_t piece)
  {
    bool halved = false;
    for (const StretchPlace& place : this->placesOf(piece, StretchForm::Spline))
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

  /// Lets what was made straight bend again, if there is any.
  bool loosen(std::size_t piece)
  {
    bool loosened = false;
    for (std::size_t c = 0; c < this->Fit.plan.size(); ++c)
    {
      const BorderChain& chain = this->Chains.chains()[c];
      for (PlannedStretch& stretch : this->Fit.plan[c].stretches)
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

  /// Of a stretch the one that is its mirror image, maybe itself.
  std::optional<StretchPlace> imageOf(const StretchPlace& place) const
  {
    const OutlineMirror& mirror = this->Fit.mirrors[this->Chains.chains()[place.chain].piece];
    for (const MirroredStretches& pair : mirror.stretches)
    {
      if (place.chain == mirror.chain && (place.stretch == pair.one || place.stretch == pair.other))
      {
        return StretchPlace{ mirror.chain, place.stretch == pair.one ? pair.other : pair.one };
      }
    }
    return std::nullopt;
  }

  /// Puts the ends of intervals of mirrored stretches where the lengths of the curves say.
  void placeIntervals(std::size_t piece)
  {
    const OutlineMirror& mirror = this->Fit.mirrors[piece];
    for (const MirroredStretches& pair : mirror.stretches)
    {
      this->placeIntervals(StretchPlace{ mirror.chain, pair.one });
      if (!pair.own())
      {
        this->placeIntervals(StretchPlace{ mirror.chain, pair.other });
      }
    }
  }

  void placeIntervals(const StretchPlace& place)
  {
    PlannedChain& chain = this->Fit.plan[place.chain];
    const PlannedStretch& stretch = this->at(place);
    PlannedInterval whole;
    whole.places = { stretch.breaks.front(), stretch.breaks.back() };
    const IntervalCurve curve(this->Fit.spans[place.chain], whole);
    double length = 0.0;
    for (std::size_t k = stretch.firstInterval; k + 1 < stretch.endInterval; ++k)
    {
      length += chain.intervals[k].length;
      chain.intervals[k].places[1] = chain.intervals[k + 1].places[0] =
        curve.placeAt(length / curve.length());
    }
  }

  bool isOf(std::size_t chain, std::size_t piece) const
  {
    return this->Chains.chains()[chain].piece == piece;
  }

  /// All stretches of a piece that are of a form.
  std::vector<StretchPlace> placesOf(std::size_t piece, StretchForm form) const
  {
    std::vector<StretchPlace> places;
    for (std::size_t c = 0; c < this->Fit.plan.size(); ++c)
    {
      for (std::size_t s = 0; this->isOf(c, piece) && s < this->Fit.plan[c].stretches.size(); ++s)
      {
        if (this->Fit.plan[c].stretches[s].form == form)
        {
          places.push_back({ c, s });
        }
      }
    }
    return places;
  }

  double toleranceAt(const StretchPlace& place, std::size_t point) const
  {
    const PlannedChain& chain = this->Fit.plan[place.chain];
    const PlannedStretch& stretch = chain.stretches[place.stretch];
    const double arc = this->Chains.chains()[place.chain].arc[point];
    const auto first = chain.intervals.begin() + static_cast<std::ptrdiff_t>(stretch.firstInterval);
    const auto last =
      chain.intervals.begin() + static_cast<std::ptrdiff_t>(stretch.endInterval) - 1;
    return std::partition_point(first, last, [arc](const PlannedInterval& interval) {
      return interval.end < arc;
    })->tolerance;
  }

  /// The largest deviation of a stretch over its tolerance.
  double excess(const StretchPlace& place) const
  {
    const PlannedStretch& stretch = this->Fit.plan[place.chain].stretches[place.stretch];
    double most = 0.0;
    for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
    {
      most = std::max(most, this->Deviation[place.chain][k] / this->toleranceAt(place, k));
    }
    return most;
  }

  bool keepsTolerances(std::size_t piece) const
  {
    for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
    {
      for (const StretchPlace& place : this->placesOf(piece, form))
      {
        if (this->excess(place) > 1.0)
        {
          return false;
        }
      }
    }
    return true;
  }

  double largestDeviation(std::size_t piece) const
  {
    double most = 0.0;
    for (std::size_t c = 0; c < this->Fit.plan.size(); ++c)
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

  PieceNetwork networkOf(std::size_t piece) const
  {
    return { this->All, this->Chains, this->Fit.plan, piece, this->Fit.mirrors[piece],
      this->Work[piece] };
  }

  /// Finds the curves of a piece. \return false: there are none, and those before stay
  bool solve(std::size_t piece)
  {
    const PieceNetwork network = this->networkOf(piece);
    const FairCurves curves = solveFairNetwork(network.network(), this->Wave[piece]);
    if (curves.converged)
    {
      network.take(curves, this->Fit.spans, this->Deviation);
    }
    return curves.converged;
  }

  /// The same with more weight on what is too far from its curve.
  /// \param times how often that may be given
  bool solveEvenly(std::size_t piece, int times)
  {
    bool solved = this->solve(piece);
    for (int k = 0; solved && k < times; ++k)
    {
      bool any = false;
      for (const StretchForm form : { StretchForm::Spline, StretchForm::Straight })
      {
        for (const StretchPlace& place : this->placesOf(piece, form))
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

  bool emphasizeStretch(const StretchPlace& place)
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

  /// Draws a stretch as it was tried by itself, between nodes as they are.
  /// \param part of the trial that it is
  void take(const StretchPlace& place, const FairTrial& trial, std::size_t part)
  {
    PlannedStretch& stretch = this->at(place);
    const double start = stretch.breaks.front();
    const double end = stretch.breaks.back();
    std::vector<FairSpan>& spans = this->Fit.spans[place.chain];
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

  /// Draws all of the piece as it was.
  void drawEdges(std::size_t piece)
  {
    for (std::size_t c = 0; c < this->Fit.plan.size(); ++c)
    {
      const BorderChain& chain = this->Chains.chains()[c];
      if (chain.piece != piece)
      {
        continue;
      }
      this->Fit.spans[c].clear();
      this->Deviation[c].assign(chain.arc.size(), 0.0);
      for (std::size_t k = 0; k < chain.edges(); ++k)
      {
        const Point2 from = this->All.at(chain.point(k));
        const Point2 way = this->All.at(chain.point(k + 1)) - from;
        this->Fit.spans[c].push_back({ chain.arc[k], chain.arc[k + 1],
          { from, from + way / 3.0, from + 2.0 * way / 3.0, from + way } });
      }
    }
  }

  PlannedStretch& at(const StretchPlace& place)
  {
    return this->Fit.plan[place.chain].stretches[place.stretch];
  }

  const DrawingSource& All;
  const BorderChains& Chains;
  std::vector<double>& Work; ///< see FairNetwork, by piece
  FairFit Fit;
  std::vector<std::vector<double>> Deviation; ///< of each point of each chain, millimetres
  std::vector<double> Wave; ///< by piece the longest wave that is smoothed away, millimetres
};
}

FairFit fitFairBorders(
  const DrawingSource& all, const BorderChains& chains, const FairLimits& limits)
{
  return Fitting(all, chains, limits).run();
}
}
