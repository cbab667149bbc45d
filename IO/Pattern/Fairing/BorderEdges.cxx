// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/BorderEdges.h"

#include <algorithm>
#include <map>

namespace flattening::pattern
{
namespace
{
constexpr double shortestEdge = 6.0; ///< millimetres; the breaks of both sides are rarely the same
constexpr double crossing = 1e-6;    ///< of an edge: a break so near to its end is no other one

/// Of breaks that are close to each other the mean, the same from either end.
std::vector<double> withoutShortEdges(std::vector<double> breaks, double shortest)
{
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> kept;
  for (std::size_t k = 0; k < breaks.size();)
  {
    double sum = 0.0;
    const std::size_t first = k;
    do
    {
      sum += breaks[k++];
    } while (k < breaks.size() && breaks[k] - breaks[k - 1] < shortest);
    const double mean = sum / static_cast<double>(k - first);
    if (mean > shortest && mean < 1.0 - shortest)
    {
      kept.push_back(mean);
    }
  }
  return kept;
}

/// A part of a chain as one cubic curve, which follows what lies beyond a break near one of its
/// ends by its slope there, and has the same length.
FairSpan oneCubic(const std::vector<FairSpan>& spans, double from, double to, double length)
{
  const double margin = crossing * (to - from);
  const FairSpan& first = spanAt(spans, from + margin);
  const FairSpan& last = spanAt(spans, to - margin);
  if (&first == &last)
  {
    return partOf(first, from, to);
  }
  const Point2 start = first.at(from);
  const Point2 end = last.at(to);
  const auto cubic = [&](double handle) {
    return FairSpan{ from, to,
      { start, start + handle * first.slope(from).normalized(),
        end - handle * last.slope(to).normalized(), end } };
  };
  double low = 0.0;
  double high = length;
  for (int step = 0; step < 60; ++step)
  {
    const double middle = (low + high) / 2.0;
    (cubic(middle).length() < length ? low : high) = middle;
  }
  return cubic((low + high) / 2.0);
}

class EdgeDivision
{
public:
  EdgeDivision(const DrawingSource& all, const FairBorders& fair)
    : All(all)
    , Fair(fair)
    , Borders(all.loops.size())
  {
  }

  std::vector<std::vector<BorderEdge>> divide()
  {
    for (std::size_t p = 0; p < this->All.loops.size(); ++p)
    {
      const Indices& loop = this->All.loops[p].front();
      const std::size_t chain = this->Fair.chains().find(loop[0], loop[1])->chain; // all are chains
      const std::size_t count = this->Fair.plan()[chain].intervals.size();
      for (std::size_t k = 0; k < count; ++k)
      {
        this->addInterval(p, chain, k);
      }
    }
    this->sew();
    return std::move(this->Borders);
  }

private:
  using Key = std::array<std::size_t, 2>; // chain and interval
  struct Run
  {
    std::size_t piece = 0;
    std::size_t first = 0;
    std::size_t count = 0;
  };

  void addInterval(std::size_t piece, std::size_t c, std::size_t k)
  {
    const PlannedInterval& interval = this->Fair.plan()[c].intervals[k];
    const IntervalCurve curve(this->Fair.spans()[c], interval.places);
    std::vector<double> breaks = curve.breaks(false);
    bool smooth = this->isSmooth(c, k);
    const auto [chain, other] = interval.partner;
    if (chain != PlannedInterval::none)
    {
      const IntervalCurve sewn(
        this->Fair.spans()[chain], this->Fair.plan()[chain].intervals[other].places);
      const std::vector<double> others = sewn.breaks(interval.reversed);
      breaks.insert(breaks.end(), others.begin(), others.end());
      smooth = smooth && this->isSmooth(chain, other);
    }
    breaks =
      withoutShortEdges(std::move(breaks), smooth ? shortestEdge / interval.length : sameBreak);
    breaks.push_back(1.0);
    std::vector<BorderEdge>& border = this->Borders[piece];
    Run run{ piece, border.size(), 0 };
    const std::string name = this->nameAt(c, (interval.start + interval.end) / 2.0);
    double last = 0.0;
    double start = interval.places[0];
    for (const double share : breaks)
    {
      const double end = curve.placeAt(share);
      BorderEdge edge;
      edge.curve = oneCubic(this->Fair.spans()[c], start, end, (share - last) * curve.length());
      edge.name = name;
      border.push_back(edge);
      last = share;
      start = end;
      ++run.count;
    }
    this->Runs[{ c, k }] = run;
  }

  /// Whether an interval is part of a spline, and so without corners.
  bool isSmooth(std::size_t c, std::size_t k) const
  {
    return stretchOf(this->Fair.plan()[c], k).form == StretchForm::Spline;
  }

  std::string nameAt(std::size_t c, double arc) const
  {
    const BorderChain& chain = this->Fair.chains().chains()[c];
    const std::size_t edge = chain.edgeAt(arc);
    const SourceWire* const wire =
      wireOf(this->All.source, this->All.wires, chain.point(edge), chain.point(edge + 1));
    return wire && wire->type != WireType::Boundary ? wire->name : "";
  }

  void sew()
  {
    for (const auto& [key, run] : this->Runs)
    {
      const PlannedInterval& interval = this->Fair.plan()[key[0]].intervals[key[1]];
      const auto partner = this->Runs.find(interval.partner);
      if (partner == this->Runs.end() || partner->second.count != run.count)
      {
        continue;
      }
      for (std::size_t k = 0; k < run.count; ++k)
      {
        const std::size_t other = interval.reversed ? run.count - 1 - k : k;
        BorderEdge& edge = this->Borders[run.piece][run.first + k];
        edge.sewn[0] = partner->second.piece;
        edge.sewn[1] = partner->second.first + other;
      }
    }
  }

  const DrawingSource& All;
  const FairBorders& Fair;
  std::vector<std::vector<BorderEdge>> Borders;
  std::map<Key, Run> Runs;
};
}

std::vector<std::vector<BorderEdge>> borderEdges(const DrawingSource& all, const FairBorders& fair)
{
  return EdgeDivision(all, fair).divide();
}
}
