// SPDX-License-Identifier: BSD-3-Clause
#include "BorderEdges.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double sameBreak = 1e-7; ///< of an interval

/// The curve of an interval.
class IntervalCurve
{
public:
  IntervalCurve(const std::vector<FairSpan>& spans, const PlannedInterval& interval)
    : End(interval.end)
  {
    const double least = sameBreak * (interval.end - interval.start);
    for (const FairSpan& span : spans)
    {
      if (span.to > interval.start + least && span.from < interval.end - least)
      {
        this->Parts.push_back(
          partOf(span, std::max(span.from, interval.start), std::min(span.to, interval.end)));
      }
    }
    for (const FairSpan& part : this->Parts)
    {
      this->Length += part.length();
    }
  }

  /// Where it is divided, as shares of its length. \param fromEnd the shares are those from its end
  std::vector<double> breaks(bool fromEnd) const
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

  /// The place along the chain at a share of the length.
  double placeAt(double share) const
  {
    double left = share * this->Length;
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

private:
  double End = 0.0;
  double Length = 0.0;
  std::vector<FairSpan> Parts;
};

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
      ChainEdge place;
      this->Fair.chains().find(loop[0], loop[1], place); // all loops are chains
      const std::size_t count = this->Fair.plan()[place.chain].intervals.size();
      for (std::size_t k = 0; k < count; ++k)
      {
        this->addInterval(p, place.chain, k);
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
    const IntervalCurve curve(this->Fair.spans()[c], interval);
    std::vector<double> breaks = curve.breaks(false);
    if (interval.partner[0] != PlannedInterval::none)
    {
      const std::vector<double> others = IntervalCurve(this->Fair.spans()[interval.partner[0]],
        this->Fair.plan()[interval.partner[0]].intervals[interval.partner[1]])
                                           .breaks(interval.reversed);
      breaks.insert(breaks.end(), others.begin(), others.end());
    }
    breaks.push_back(1.0);
    std::sort(breaks.begin(), breaks.end());
    std::vector<BorderEdge>& border = this->Borders[piece];
    Run run{ piece, border.size(), 0 };
    const std::string name = this->nameAt(c, (interval.start + interval.end) / 2.0);
    double last = 0.0;
    double start = interval.start;
    for (const double share : breaks)
    {
      if (share - last < sameBreak)
      {
        continue;
      }
      const double end = curve.placeAt(share);
      const FairSpan& span = spanAt(this->Fair.spans()[c], (start + end) / 2.0);
      BorderEdge edge;
      edge.curve = partOf(span, start, end);
      edge.name = name;
      border.push_back(edge);
      last = share;
      start = end;
      ++run.count;
    }
    this->Runs[{ c, k }] = run;
  }

  std::string nameAt(std::size_t c, double arc) const
  {
    const BorderChain& chain = this->Fair.chains().chains()[c];
    const auto above = std::upper_bound(chain.arc.begin(), chain.arc.end(), arc);
    const auto edge = static_cast<std::size_t>(above - chain.arc.begin()) - 1;
    const PatternSource& source = this->All.source;
    const std::size_t wire =
      wireOf(source, this->All.wires, chain.point(edge), chain.point(edge + 1));
    return wire < source.wires.size() && source.wires[wire].type != WireType::Boundary
      ? source.wires[wire].name
      : "";
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
}
