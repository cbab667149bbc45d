// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairFit.h"

#include "Fairing/FairTrial.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace flattening::pattern
{
namespace
{
/// Where a stretch of a network comes from.
struct StretchOrigin
{
  std::size_t chain = 0;
  std::size_t firstPoint = 0; ///< of the chain
  double start = 0.0;         ///< along it
};

constexpr double sameStop = 1.0;   ///< of a stop and the image of another, millimetres
constexpr double leastPart = 1e-6; ///< of an interval

/// Takes the ends of intervals away whose place follows from others, since the curve is the mirror
/// image of another, or of itself.
void leaveWhatFollows(const FairStretch& one, FairStretch& other)
{
  const bool own = &one == &other;
  std::vector<double> images; // of ends of intervals
  if (own)
  {
    images.push_back(other.length() / 2.0);
  }
  for (std::size_t k = 0; !own && k + 1 < one.intervals.size(); ++k)
  {
    images.push_back((1.0 - one.intervals[k].end / one.length()) * other.length());
  }
  std::vector<FairInterval> left;
  double length = 0.0;
  for (const FairInterval& interval : other.intervals)
  {
    length += interval.length;
    const bool isLast = &interval == &other.intervals.back();
    const bool follows = std::any_of(images.begin(), images.end(),
      [&interval](double image) { return std::abs(image - interval.end) < sameStop; });
    if (isLast || (!follows && !other.straight))
    {
      left.push_back({ interval.end, length, isLast && !own });
      length = 0.0;
      if (own)
      {
        images.push_back(other.length() - interval.end);
      }
    }
  }
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

/// The planned chains of one piece as a network to solve. Its nodes are corners, and points that
/// chains share.
class PieceNetwork
{
public:
  PieceNetwork(const DrawingSource& all, const BorderChains& chains,
    const std::vector<PlannedChain>& plan, std::size_t piece, const OutlineMirror& mirror)
    : All(all)
    , Chains(chains)
    , Plan(plan)
  {
    for (std::size_t c = 0; c < plan.size(); ++c)
    {
      for (const PlannedStretch& stretch : plan[c].stretches)
      {
        const bool isRaw = stretch.form == StretchForm::Raw;
        for (std::size_t k = stretch.firstPoint;
             chains.chains()[c].piece == piece && k < stretch.lastPoint;
             k = isRaw ? k + 1 : stretch.lastPoint)
        {
          this->add(c, stretch, k, isRaw ? k + 1 : stretch.lastPoint);
        }
      }
    }
    this->Network.axis = mirror.axis;
    for (const MirroredStretches& pair : mirror.stretches)
    {
      const std::size_t one = this->indexOf({ mirror.chain, pair.one });
      const std::size_t other = this->indexOf({ mirror.chain, pair.other });
      leaveWhatFollows(this->Network.stretches[one], this->Network.stretches[other]);
      this->Network.images.push_back({ one, other });
    }
  }

  const FairNetwork& network() const { return this->Network; }
  const std::vector<StretchOrigin>& origins() const { return this->Origins; }

  /// The number of a stretch in it that is no raw one, or of the first edge of a raw one.
  std::size_t indexOf(const StretchPlace& place) const
  {
    const std::size_t first = this->Plan[place.chain].stretches[place.stretch].firstPoint;
    const auto found =
      std::find_if(this->Origins.begin(), this->Origins.end(), [&](const StretchOrigin& origin) {
        return origin.chain == place.chain && origin.firstPoint == first;
      });
    return static_cast<std::size_t>(found - this->Origins.begin());
  }

private:
  std::size_t nodeAt(Index point)
  {
    const auto [entry, isNew] = this->Nodes.emplace(point, this->Network.nodes.size());
    if (isNew)
    {
      this->Network.nodes.push_back(this->All.at(point));
    }
    return entry->second;
  }

  /// Adds a stretch, or an edge of a raw one.
  void add(std::size_t c, const PlannedStretch& planned, std::size_t first, std::size_t last)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    const bool isRaw = planned.form == StretchForm::Raw;
    FairStretch stretch;
    const StretchOrigin origin{ c, first, chain.arc[first] };
    stretch.from = this->nodeAt(chain.point(first));
    stretch.to = this->nodeAt(chain.point(last));
    stretch.smoothEnds = planned.smoothEnds && !isRaw;
    stretch.straight = planned.form != StretchForm::Spline;
    for (std::size_t k = first; k <= last; ++k)
    {
      const Index v = chain.point(k);
      stretch.arc.push_back(chain.arc[k] - origin.start);
      stretch.points.push_back(this->All.at(v));
      stretch.weights.push_back(isRaw ? 1.0 : planned.weights[k - first]);
      stretch.tolerances.push_back(isRaw ? 0.0 : toleranceAt(this->Plan[c], planned, chain.arc[k]));
      if (k > first && k<last&& this->Chains.chainsAt(v)> 1)
      {
        stretch.hooks.push_back({ stretch.arc.back(), this->nodeAt(v) });
      }
    }
    if (isRaw)
    {
      const double length = stretch.arc.back();
      stretch.breaks = { 0.0, length };
      stretch.intervals = { { length, length } };
    }
    for (std::size_t k = 0; !isRaw && k < planned.breaks.size(); ++k)
    {
      stretch.breaks.push_back(planned.breaks[k] - origin.start);
    }
    for (std::size_t k = planned.firstInterval; !isRaw && k < planned.endInterval; ++k)
    {
      addInterval(this->Plan[c].intervals[k], origin.start, stretch);
    }
    this->Network.stretches.push_back(std::move(stretch));
    this->Origins.push_back(origin);
  }

  const DrawingSource& All;
  const BorderChains& Chains;
  const std::vector<PlannedChain>& Plan;
  FairNetwork Network;
  std::vector<StretchOrigin> Origins;
  std::map<Index, std::size_t> Nodes;
};

constexpr int rounds = 24;
constexpr int emphases = 5;      ///< in a row, of a plan
constexpr double nearly = 1.3;   ///< of a tolerance: more emphasis may help
constexpr int tolerated = 3;     ///< how often
constexpr double progress = 0.9; ///< what more breaks must make of what is too far

/// Of two plans of one chain before a search: all else follows from these.
bool samePlan(const PlannedChain& a, const PlannedChain& b)
{
  const auto sameInterval = [](const PlannedInterval& one, const PlannedInterval& other) {
    return std::tie(one.start, one.end, one.length, one.tolerance) ==
      std::tie(other.start, other.end, other.length, other.tolerance);
  };
  const auto sameStretch = [](const PlannedStretch& one, const PlannedStretch& other) {
    return std::tie(one.firstPoint, one.lastPoint, one.form, one.breaks) ==
      std::tie(other.firstPoint, other.lastPoint, other.form, other.breaks);
  };
  return std::equal(a.intervals.begin(), a.intervals.end(), b.intervals.begin(), b.intervals.end(),
           sameInterval) &&
    std::equal(
      a.stretches.begin(), a.stretches.end(), b.stretches.begin(), b.stretches.end(), sameStretch);
}

/// Fits piece by piece: a plan of all stretches, and the curves that are found for it.
class Fitting
{
public:
  /// Source and chains stay the caller's.
  Fitting(const DrawingSource& all, const BorderChains& chains, const FairLimits& limits)
    : All(all)
    , Chains(chains)
  {
    const std::size_t pieces = all.loops.size();
    this->ChainsOf.resize(pieces);
    for (std::size_t c = 0; c < chains.chains().size(); ++c)
    {
      this->ChainsOf[chains.chains()[c].piece].push_back(c);
    }
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
      for (const std::size_t c : this->ChainsOf[p])
      {
        length += chains.chains()[c].length();
        edges += chains.chains()[c].edges();
      }
      this->Wave.push_back(length / static_cast<double>(std::max<std::size_t>(edges, 1)));
    }
    equalizeMirroredLengths(this->Fit.mirrors, this->Fit.plan);
  }

  FairFit run(const FairFit& before, const Execution& execution)
  {
    this->Fit.start = this->Fit.plan;
    const std::size_t pieces = this->Fit.solved.size();
    for (std::size_t p = 0; p < pieces; ++p)
    {
      execution.report(static_cast<double>(p) / static_cast<double>(pieces), "Smoothing outlines");
      if (this->beginsAs(before, p))
      {
        this->takePiece(before, p);
        continue;
      }
      this->fitPiece(p);
      this->placeIntervals(p);
      double& most = this->Fit.deviation.emplace_back(0.0);
      for (const std::size_t c : this->ChainsOf[p])
      {
        for (const double off : this->Deviation[c])
        {
          most = std::max(most, off);
        }
      }
    }
    return std::move(this->Fit);
  }

private:
  bool beginsAs(const FairFit& before, std::size_t piece) const
  {
    const std::vector<std::size_t>& own = this->ChainsOf[piece];
    return !before.start.empty() &&
      before.mirrors[piece].stretches.size() == this->Fit.mirrors[piece].stretches.size() &&
      std::all_of(own.begin(), own.end(),
        [&](std::size_t c) { return samePlan(this->Fit.start[c], before.start[c]); });
  }

  void takePiece(const FairFit& before, std::size_t piece)
  {
    for (const std::size_t c : this->ChainsOf[piece])
    {
      this->Fit.plan[c] = before.plan[c];
      this->Fit.spans[c] = before.spans[c];
    }
    std::copy_if(before.left.begin(), before.left.end(), std::back_inserter(this->Fit.left),
      [this, piece](
        const LeftStretch& left) { return this->Chains.chains()[left.chain].piece == piece; });
    this->Fit.solved[piece] = before.solved[piece];
    this->Fit.unmirrored[piece] = before.unmirrored[piece];
    this->Fit.deviation.push_back(before.deviation[piece]);
  }

  void fitPiece(std::size_t p)
  {
    for (int round = 0; round < rounds && !this->Fit.unmirrored[p]; ++round)
    {
      if (!(this->solveEvenly(p) ? this->refine(p, round + 4 > rounds) : this->halveSpans(p)))
      {
        break;
      }
      mirrorPlan(this->Fit.mirrors[p], this->Fit.plan);
    }
    bool solved = !this->Fit.unmirrored[p] && this->solve(p);
    for (std::vector<StretchPlace> bad; solved && !(bad = this->badPlaces(p)).empty();)
    {
      for (const StretchPlace& place : bad)
      {
        this->leave(place);
      }
      solved = !this->Fit.unmirrored[p] && this->solve(p);
    }
    if (solved)
    {
      this->coarsen(p);
      return;
    }
    if (this->Fit.mirrors[p].found() && !this->Fit.unmirrored[p])
    {
      this->Fit.unmirrored[p].emplace();
    }
    this->leaveAll(p);
  }

  /// Breaks where the tolerance is not kept, and the stretch as it was where they do not help.
  /// \param last nothing is tried any more \return whether anything has changed
  bool refine(std::size_t piece, bool last)
  {
    const std::vector<StretchPlace> bad = this->badPlaces(piece);
    const auto isSpline = [this](const StretchPlace& place) {
      return this->at(place).form == StretchForm::Spline;
    };
    // What is straight may be off because of the splines that it meets.
    const bool any = std::any_of(bad.begin(), bad.end(), isSpline);
    for (const StretchPlace& place : bad)
    {
      if (!any)
      {
        this->at(place).form = StretchForm::Spline; // lengths beside it have moved it
      }
      else if (isSpline(place) && (last || !this->addBreaks(place)))
      {
        this->leave(place);
      }
    }
    return !bad.empty();
  }

  /// Lets a stretch be as it was.
  void leave(const StretchPlace& place)
  {
    PlannedStretch& stretch = this->at(place);
    LeftStretch left{ place.chain, stretch.firstPoint, 0.0, 0.0 };
    for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
    {
      const double off = this->Deviation[place.chain][k];
      const double tolerance = this->toleranceOf(place, k);
      if (off > tolerance && off > left.needed)
      {
        left.needed = off;
        left.tolerance = tolerance;
      }
    }
    if (this->imageOf(place))
    {
      this->Fit.unmirrored[this->Chains.chains()[place.chain].piece] = left;
      return;
    }
    stretch.form = StretchForm::Raw;
    this->Fit.left.push_back(left);
  }

  /// Draws all of the piece as it was.
  void leaveAll(std::size_t piece)
  {
    this->Fit.solved[piece] = false;
    for (const std::size_t c : this->ChainsOf[piece])
    {
      const BorderChain& chain = this->Chains.chains()[c];
      for (PlannedStretch& stretch : this->Fit.plan[c].stretches)
      {
        stretch.form = StretchForm::Raw;
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
        off = off || this->Deviation[place.chain][point] > this->toleranceOf(place, point);
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
    for (const StretchPlace& place : this->smoothPlaces(piece))
    {
      const std::optional<StretchPlace> image = this->imageOf(place);
      if (this->at(place).form == StretchForm::Straight || !curves.converged ||
        (image && image->stretch < place.stretch)) // with the other
      {
        continue;
      }
      std::vector<StretchPlace> places{ place };
      std::vector<std::size_t> parts{ network.indexOf(place) };
      if (image && !(*image == place))
      {
        places.push_back(*image);
        parts.push_back(network.indexOf(*image));
      }
      const std::optional<SimplerStretches> simpler = simplerStretches(
        network.network(), parts, curves.nodes, this->Wave[piece], this->at(place).leastSpans());
      for (std::size_t k = 0; simpler && k < places.size(); ++k)
      {
        this->take(places[k], *simpler, k);
      }
    }
  }

  /// Gives all splines of a piece twice as many curves, where they may have them.
  bool halveSpans(std::size_t piece)
  {
    bool halved = false;
    for (const StretchPlace& place : this->smoothPlaces(piece))
    {
      PlannedStretch& stretch = this->at(place);
      std::fill(stretch.weights.begin(), stretch.weights.end(), 1.0);
      if (stretch.form == StretchForm::Straight || 2 * stretch.spans() > stretch.edges())
      {
        continue;
      }
      for (std::size_t k = stretch.spans(); k > 0; --k)
      {
        stretch.breaks.insert(stretch.breaks.begin() + static_cast<std::ptrdiff_t>(k),
          (stretch.breaks[k - 1] + stretch.breaks[k]) / 2.0);
      }
      halved = true;
    }
    return halved;
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
    for (const StretchPlace& place : this->smoothPlaces(piece))
    {
      if (!this->imageOf(place))
      {
        continue;
      }
      std::vector<PlannedInterval>& intervals = this->Fit.plan[mirror.chain].intervals;
      const PlannedStretch& stretch = this->at(place);
      const IntervalCurve curve(
        this->Fit.spans[mirror.chain], { stretch.breaks.front(), stretch.breaks.back() });
      double length = 0.0;
      for (std::size_t k = stretch.firstInterval; k + 1 < stretch.endInterval; ++k)
      {
        length += intervals[k].length;
        intervals[k].places[1] = intervals[k + 1].places[0] =
          curve.placeAt(length / curve.length());
      }
    }
  }

  /// All stretches of a piece that do not stay as they were.
  std::vector<StretchPlace> smoothPlaces(std::size_t piece) const
  {
    std::vector<StretchPlace> places;
    for (const std::size_t c : this->ChainsOf[piece])
    {
      for (std::size_t s = 0; s < this->Fit.plan[c].stretches.size(); ++s)
      {
        if (this->Fit.plan[c].stretches[s].form != StretchForm::Raw)
        {
          places.push_back({ c, s });
        }
      }
    }
    return places;
  }

  /// Those of them that do not keep their tolerances.
  std::vector<StretchPlace> badPlaces(std::size_t piece) const
  {
    std::vector<StretchPlace> places = this->smoothPlaces(piece);
    eraseIf(places, [this](const StretchPlace& place) { return this->excess(place) <= 1.0; });
    return places;
  }

  double toleranceOf(const StretchPlace& place, std::size_t point) const
  {
    const PlannedChain& chain = this->Fit.plan[place.chain];
    return toleranceAt(
      chain, chain.stretches[place.stretch], this->Chains.chains()[place.chain].arc[point]);
  }

  /// Of the points of a stretch, their deviations over their tolerances.
  std::vector<double> shares(const StretchPlace& place) const
  {
    const PlannedStretch& stretch = this->Fit.plan[place.chain].stretches[place.stretch];
    std::vector<double> shares;
    for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
    {
      shares.push_back(this->Deviation[place.chain][k] / this->toleranceOf(place, k));
    }
    return shares;
  }

  double excess(const StretchPlace& place) const
  {
    const std::vector<double> shares = this->shares(place);
    return *std::max_element(shares.begin(), shares.end());
  }

  PieceNetwork networkOf(std::size_t piece) const
  {
    return { this->All, this->Chains, this->Fit.plan, piece, this->Fit.mirrors[piece] };
  }

  /// Finds the curves of a piece. \return false: there are none, and those before stay
  bool solve(std::size_t piece)
  {
    const PieceNetwork network = this->networkOf(piece);
    const FairCurves curves = solveFairNetwork(network.network(), this->Wave[piece]);
    if (!curves.converged)
    {
      return false;
    }
    for (const std::size_t c : this->ChainsOf[piece])
    {
      this->Fit.spans[c].clear();
      this->Deviation[c].assign(this->Chains.chains()[c].arc.size(), 0.0);
    }
    for (std::size_t s = 0; s < network.origins().size(); ++s)
    {
      const StretchOrigin& origin = network.origins()[s];
      for (FairSpan span : curves.spans[s])
      {
        span.from += origin.start;
        span.to += origin.start;
        this->Fit.spans[origin.chain].push_back(span);
      }
      for (std::size_t k = 0; k < curves.deviation[s].size(); ++k)
      {
        double& off = this->Deviation[origin.chain][origin.firstPoint + k];
        off = std::max(off, curves.deviation[s][k]);
      }
    }
    return true;
  }

  /// The same with more weight on what is too far from its curve.
  bool solveEvenly(std::size_t piece)
  {
    bool solved = this->solve(piece);
    for (int k = 0; solved && k < emphases; ++k)
    {
      const std::vector<StretchPlace> bad = this->badPlaces(piece);
      for (const StretchPlace& place : bad)
      {
        emphasize(this->shares(place), this->at(place).weights);
      }
      if (bad.empty())
      {
        break;
      }
      solved = this->solve(piece);
    }
    return solved;
  }

  /// Draws a stretch as it was found by itself, between nodes as they are.
  /// \param part of those that it is
  void take(const StretchPlace& place, const SimplerStretches& simpler, std::size_t part)
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
    std::vector<FairSpan> own = simpler.curves.spans[part];
    stretch.breaks.clear();
    for (FairSpan& span : own)
    {
      span.from += start;
      span.to += start;
      stretch.breaks.push_back(span.from);
    }
    own.back().to = end;
    stretch.breaks.push_back(end);
    spans.insert(at, own.begin(), own.end());
    stretch.weights = simpler.stretches[part].weights;
    // Its ends are of the stretches beside it as well, and stay.
    const std::vector<double>& deviation = simpler.curves.deviation[part];
    std::copy(deviation.begin() + 1, deviation.end() - 1,
      this->Deviation[place.chain].begin() + static_cast<std::ptrdiff_t>(stretch.firstPoint) + 1);
  }

  PlannedStretch& at(const StretchPlace& place)
  {
    return this->Fit.plan[place.chain].stretches[place.stretch];
  }

  const DrawingSource& All;
  const BorderChains& Chains;
  std::vector<std::vector<std::size_t>> ChainsOf; ///< by piece
  FairFit Fit;
  std::vector<std::vector<double>> Deviation; ///< of each point of each chain, millimetres
  std::vector<double> Wave; ///< by piece the longest wave that is smoothed away, millimetres
};
}

FairFit fitFairBorders(const DrawingSource& all, const BorderChains& chains,
  const FairLimits& limits, const FairFit& before, const Execution& execution)
{
  return Fitting(all, chains, limits).run(before, execution);
}
}
