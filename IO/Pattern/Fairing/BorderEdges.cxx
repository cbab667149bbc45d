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

/// Whether an interval of a chain is part of a spline, and so without corners.
bool isSmooth(const FairBorders& fair, std::size_t chain, std::size_t interval)
{
  return stretchOf(fair.plan()[chain], interval).form == StretchForm::Spline;
}

/// Adds the edges that the interval k of the chain c is made of.
void addEdges(const DrawingSource& all, const FairBorders& fair, std::size_t c, std::size_t k,
  std::vector<BorderEdge>& border)
{
  const PlannedInterval& interval = fair.plan()[c].intervals[k];
  const IntervalCurve curve(fair.spans()[c], interval.places);
  std::vector<double> breaks = curve.breaks(false);
  bool smooth = isSmooth(fair, c, k);
  const auto [other, there] = interval.partner;
  if (other != PlannedInterval::none)
  {
    const IntervalCurve sewn(fair.spans()[other], fair.plan()[other].intervals[there].places);
    const std::vector<double> others = sewn.breaks(interval.reversed);
    breaks.insert(breaks.end(), others.begin(), others.end());
    smooth = smooth && isSmooth(fair, other, there);
  }
  breaks =
    withoutShortEdges(std::move(breaks), smooth ? shortestEdge / interval.length : sameBreak);
  breaks.push_back(1.0);
  const BorderChain& chain = fair.chains().chains()[c];
  const std::size_t at = chain.edgeAt((interval.start + interval.end) / 2.0);
  const SourceWire* const wire =
    wireOf(all.source, all.wires, chain.point(at), chain.point(at + 1));
  double last = 0.0;
  double start = interval.places[0];
  for (const double share : breaks)
  {
    const double end = curve.placeAt(share);
    BorderEdge& edge = border.emplace_back();
    edge.curve = oneCubic(fair.spans()[c], start, end, (share - last) * curve.length());
    edge.name = wire && wire->type != WireType::Boundary ? wire->name : "";
    last = share;
    start = end;
  }
}
}

std::vector<std::vector<BorderEdge>> borderEdges(const DrawingSource& all, const FairBorders& fair)
{
  struct Run
  {
    std::size_t piece = 0;
    std::size_t first = 0;
    std::size_t count = 0;
  };
  std::vector<std::vector<BorderEdge>> borders(all.loops.size());
  std::map<std::array<std::size_t, 2>, Run> runs; // by chain and interval
  for (std::size_t p = 0; p < all.loops.size(); ++p)
  {
    const Indices& loop = all.loops[p].front();
    const std::size_t chain = fair.chains().find(loop[0], loop[1])->chain; // all are chains
    for (std::size_t k = 0; k < fair.plan()[chain].intervals.size(); ++k)
    {
      const std::size_t first = borders[p].size();
      addEdges(all, fair, chain, k, borders[p]);
      runs[{ chain, k }] = { p, first, borders[p].size() - first };
    }
  }
  for (const auto& [key, run] : runs)
  {
    const PlannedInterval& interval = fair.plan()[key[0]].intervals[key[1]];
    const auto partner = runs.find(interval.partner);
    if (partner == runs.end() || partner->second.count != run.count)
    {
      continue;
    }
    for (std::size_t k = 0; k < run.count; ++k)
    {
      const std::size_t other = interval.reversed ? run.count - 1 - k : k;
      borders[run.piece][run.first + k].sewn[0] = partner->second.piece;
      borders[run.piece][run.first + k].sewn[1] = partner->second.first + other;
    }
  }
  return borders;
}
}
