// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairPlan.h"

#include "Outlines/Grainlines.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace flattening::pattern
{
namespace
{
constexpr double closestStop = 1.0; ///< of a notch beside a corner, millimetres
constexpr double sameNotch = 1e-6;  ///< of a chain

struct FairPlanner
{
  std::vector<PlannedChain> plan()
  {
    this->findFirmPoints();
    this->Plan.resize(this->Chains.chains().size());
    std::vector<std::vector<double>> notches(this->Plan.size());
    for (const NotchPlace& notch : this->All.notches)
    {
      const std::optional<ChainEdge> place = this->Chains.find(notch.edge[0], notch.edge[1]);
      if (notch.isStop && place)
      {
        notches[place->chain].push_back(this->arcAt(*place, notch.fraction));
      }
    }
    for (std::size_t c = 0; c < this->Plan.size(); ++c)
    {
      this->addIntervals(c, notches[c]);
      this->addStretches(c);
    }
    this->findPartners();
    return std::move(this->Plan);
  }

  double arcAt(const ChainEdge& place, double fraction) const
  {
    return this->Chains.chains()[place.chain].arcWithin(
      place.edge, place.backwards ? 1.0 - fraction : fraction);
  }

  /// \param end 0: the point at which the edge starts as it was asked for, 1: that at which it ends
  std::size_t pointOf(const ChainEdge& place, int end) const
  {
    const std::size_t k = place.edge + ((end == 1) != place.backwards ? 1U : 0U);
    const BorderChain& chain = this->Chains.chains()[place.chain];
    return chain.closed ? k % chain.points.size() : k;
  }

  /// Points at which intervals end on both sides of a seam.
  void findFirmPoints()
  {
    for (const BorderChain& chain : this->Chains.chains())
    {
      this->Firm.push_back(chain.corner);
      this->Firm.back().front() = true; // where a ring is opened
    }
    for (const SourceWire& wire : this->All.source.wires)
    {
      const std::size_t last = wire.points.size() - 1;
      for (const int end : { 0, 1 })
      {
        const std::size_t k = end == 0 ? 0 : last - 1;
        const std::optional<ChainEdge> place = wire.points.size() > 1
          ? this->Chains.find(wire.points[k], wire.points[k + 1])
          : std::nullopt;
        if (place)
        {
          this->Firm[place->chain][this->pointOf(*place, end)] = true;
        }
      }
    }
    for (const SewnEdges& pair : this->All.source.sewn)
    {
      const std::optional<ChainEdge> a = this->Chains.find(pair.a[0], pair.a[1]);
      const std::optional<ChainEdge> b = this->Chains.find(pair.b[0], pair.b[1]);
      for (int end = 0; a && b && end < 2; ++end)
      {
        auto one = this->Firm[a->chain][this->pointOf(*a, end)];
        auto other = this->Firm[b->chain][this->pointOf(*b, end)];
        one = other = one || other;
      }
    }
  }

  void addIntervals(std::size_t c, const std::vector<double>& notches)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    std::vector<double> firm;
    for (std::size_t k = 0; k < chain.points.size(); ++k)
    {
      if (this->Firm[c][k])
      {
        firm.push_back(chain.arc[k]);
      }
    }
    if (chain.closed)
    {
      firm.push_back(chain.length());
    }
    const std::multiset<double> firmStops(firm.begin(), firm.end());
    std::multiset<double> all = firmStops;
    const auto isNear = [](const std::multiset<double>& places, double notch, double distance) {
      const auto after = places.upper_bound(notch - distance);
      return after != places.end() && *after < notch + distance;
    };
    for (const double notch : notches)
    {
      // Two curves may have a notch at one place. All firm points stay: stretches end there.
      if (!isNear(firmStops, notch, closestStop) && !isNear(all, notch, sameNotch * chain.length()))
      {
        all.insert(notch);
      }
    }
    const std::vector<double> stops(all.begin(), all.end());
    for (std::size_t k = 0; k + 1 < stops.size(); ++k)
    {
      const double start = stops[k];
      const double end = stops[k + 1];
      const std::size_t edge = chain.edgeAt((start + end) / 2.0);
      const double tolerance = this->Shares[chain.piece] *
        this->All.fairToleranceAlong(chain.point(edge), chain.point(edge + 1));
      this->Plan[c].intervals.push_back({ start, end, { start, end }, end - start, tolerance });
    }
  }

  void addStretches(std::size_t c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k < chain.points.size(); ++k)
    {
      if (chain.corner[k])
      {
        ends.push_back(k);
      }
    }
    const bool ring = ends.empty();
    if (ring)
    {
      ends.push_back(0);
    }
    if (chain.closed)
    {
      ends.push_back(chain.points.size());
    }
    PlannedChain& planned = this->Plan[c];
    std::size_t next = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    {
      PlannedStretch stretch;
      stretch.firstPoint = ends[k];
      stretch.lastPoint = ends[k + 1];
      stretch.firstInterval = next;
      while (next < planned.intervals.size() &&
        planned.intervals[next].start < chain.arc[stretch.lastPoint])
      {
        ++next;
      }
      stretch.endInterval = next;
      stretch.smoothEnds = ring;
      double tolerance = std::numeric_limits<double>::infinity();
      for (std::size_t i = stretch.firstInterval; i < next; ++i)
      {
        tolerance = std::min(tolerance, planned.intervals[i].tolerance);
      }
      if (tolerance == 0.0)
      {
        stretch.form = StretchForm::Raw;
      }
      else if (!ring)
      {
        this->straighten(chain, stretch, tolerance);
      }
      this->divide(chain, stretch);
      planned.stretches.push_back(stretch);
    }
  }

  /// Each length and each crossing takes away from what a spline can do: a span for three of them.
  void divide(const BorderChain& chain, PlannedStretch& stretch) const
  {
    std::size_t conditions = stretch.endInterval - stretch.firstInterval - 1;
    for (std::size_t k = stretch.firstPoint + 1; k < stretch.lastPoint; ++k)
    {
      conditions += this->Chains.chainsAt(chain.point(k)) > 1 ? 1 : 0;
    }
    const std::size_t spans = std::max(stretch.leastSpans(), 1 + conditions / 3);
    const double start = chain.arc[stretch.firstPoint];
    const double length = chain.arc[stretch.lastPoint] - start;
    for (std::size_t k = 0; k < spans; ++k)
    {
      stretch.breaks.push_back(
        start + length * static_cast<double>(k) / static_cast<double>(spans));
    }
    stretch.breaks.push_back(chain.arc[stretch.lastPoint]);
    stretch.weights.assign(stretch.edges() + 1, 1.0);
  }

  void straighten(const BorderChain& chain, PlannedStretch& stretch, double tolerance) const
  {
    Points2 line;
    for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
    {
      line.push_back(this->All.at(chain.point(k)));
    }
    const double length = (line.back() - line.front()).norm();
    stretch.bend = farthestFromChord(line);
    if (stretch.bend <= std::min(tolerance, straightness * length))
    {
      stretch.form = StretchForm::Straight;
    }
  }

  void findPartners()
  {
    for (std::size_t c = 0; c < this->Plan.size(); ++c)
    {
      for (PlannedInterval& interval : this->Plan[c].intervals)
      {
        this->findPartner(c, interval);
      }
    }
    for (PlannedChain& chain : this->Plan)
    {
      for (PlannedInterval& interval : chain.intervals)
      {
        if (interval.partner[0] == PlannedInterval::none)
        {
          continue;
        }
        PlannedInterval& other = this->Plan[interval.partner[0]].intervals[interval.partner[1]];
        const double mean = (interval.length + other.length) / 2.0;
        if (std::abs(interval.length - other.length) < sameLength * mean)
        {
          interval.length = other.length = mean;
        }
      }
    }
  }

  void findPartner(std::size_t c, PlannedInterval& interval) const
  {
    const BorderChain& chain = this->Chains.chains()[c];
    const double middle = (interval.start + interval.end) / 2.0;
    const std::size_t edge = chain.edgeAt(middle);
    const auto sewn = this->All.partners.find(edgeKey(chain.point(edge), chain.point(edge + 1)));
    const std::optional<ChainEdge> place = sewn == this->All.partners.end()
      ? std::nullopt
      : this->Chains.find(sewn->second[0], sewn->second[1]);
    if (!place)
    {
      return;
    }
    const double fraction = (middle - chain.arc[edge]) / (chain.arc[edge + 1] - chain.arc[edge]);
    const double there = this->arcAt(*place, fraction);
    const std::vector<PlannedInterval>& others = this->Plan[place->chain].intervals;
    const auto found = std::lower_bound(others.begin(), others.end(), there,
      [](const PlannedInterval& other, double at) { return other.end < at; });
    if (found != others.end() && found->start <= there)
    {
      interval.partner = { place->chain, static_cast<std::size_t>(found - others.begin()) };
      interval.reversed = place->backwards;
    }
  }

  const DrawingSource& All;
  const BorderChains& Chains;
  const std::vector<double>& Shares;
  std::vector<std::vector<bool>> Firm{}; ///< points of the chains
  std::vector<PlannedChain> Plan{};
};
}

std::vector<PlannedChain> planFairBorders(
  const DrawingSource& all, const BorderChains& chains, const std::vector<double>& shares)
{
  return FairPlanner{ all, chains, shares }.plan();
}

const PlannedStretch& stretchOf(const PlannedChain& chain, std::size_t interval)
{
  return *std::find_if(chain.stretches.begin(), chain.stretches.end() - 1,
    [interval](const PlannedStretch& stretch) { return interval < stretch.endInterval; });
}

double toleranceAt(const PlannedChain& chain, const PlannedStretch& stretch, double arc)
{
  const auto begin = chain.intervals.begin();
  return std::partition_point(begin + static_cast<std::ptrdiff_t>(stretch.firstInterval),
    begin + static_cast<std::ptrdiff_t>(stretch.endInterval) - 1,
    [arc](const PlannedInterval& interval) { return interval.end < arc; })
    ->tolerance;
}

IntervalCurve::IntervalCurve(
  const std::vector<FairSpan>& spans, const std::array<double, 2>& places)
  : Start(places[0])
  , End(places[1])
{
  const double least = sameBreak * (this->End - this->Start);
  const double start = this->Start + least;
  for (auto span = std::partition_point(
         spans.begin(), spans.end(), [start](const FairSpan& one) { return one.to <= start; });
       span != spans.end() && span->from < this->End - least; ++span)
  {
    this->Parts.push_back(
      partOf(*span, std::max(span->from, this->Start), std::min(span->to, this->End)));
  }
  this->Length = curveLength(this->Parts);
}

std::vector<double> IntervalCurve::breaks(bool fromEnd) const
{
  std::vector<double> breaks;
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < this->Parts.size(); ++k)
  {
    length += this->Parts[k].length();
    breaks.push_back(fromEnd ? 1.0 - length / this->Length : length / this->Length);
  }
  return breaks;
}

double IntervalCurve::placeAt(double share) const
{
  double left = share * this->Length;
  if (left < sameBreak * this->Length)
  {
    return this->Start;
  }
  for (const FairSpan& part : this->Parts)
  {
    const double length = part.length();
    if (std::abs(left - length) < sameBreak * this->Length)
    {
      return &part == &this->Parts.back() ? this->End : part.to;
    }
    if (left < length)
    {
      double low = part.from;
      double high = part.to;
      for (int step = 0; step < 50; ++step)
      {
        const double middle = (low + high) / 2.0;
        (partOf(part, part.from, middle).length() < left ? low : high) = middle;
      }
      return low;
    }
    left -= length;
  }
  return this->End;
}
}
