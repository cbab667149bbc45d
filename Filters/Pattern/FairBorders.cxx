// SPDX-License-Identifier: BSD-3-Clause
#include "FairBorders.h"

#include "FairStrain.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double mostRise = 0.003; ///< of strain
constexpr double leastShare = 0.1;

/// The parts of a chain between two places, as they are met from the first to the second.
void addParts(
  const std::vector<FairSpan>& spans, double from, double to, std::vector<FairSpan>& parts)
{
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  const double least = 1e-9 * std::max(spans.back().to, high - low);
  std::vector<FairSpan> found;
  for (const FairSpan& span : spans)
  {
    const double start = std::max(low, span.from);
    const double end = std::min(high, span.to);
    if (end - start > least)
    {
      found.push_back(from <= to ? partOf(span, start, end) : partOf(span, end, start));
    }
  }
  if (from > to)
  {
    std::reverse(found.begin(), found.end());
  }
  parts.insert(parts.end(), found.begin(), found.end());
}
}

FairBorders::FairBorders(const DrawingSource& all)
  : All(all)
  , Chains(all)
{
  std::vector<double> shares(all.loops.size(), 1.0);
  do
  {
    this->Fit.emplace(all, this->Chains, shares);
    this->place();
    this->report();
    for (std::size_t p = 0; p < shares.size(); ++p)
    {
      this->Reports[p].share = shares[p];
    }
  } while (this->lower(shares));
}

bool FairBorders::lower(std::vector<double>& shares) const
{
  bool lowered = false;
  for (std::size_t p = 0; p < shares.size(); ++p)
  {
    const FairPieceReport& report = this->Reports[p];
    if (shares[p] > 0.0 && report.strain - report.strainBefore > mostRise)
    {
      shares[p] = shares[p] > leastShare ? shares[p] / 2.0 : 0.0;
      lowered = true;
    }
  }
  return lowered;
}

std::string FairBorders::nameOf(std::size_t c, std::size_t point) const
{
  const BorderChain& chain = this->Chains.chains()[c];
  const std::size_t wire =
    wireOf(this->All.source, this->All.wires, chain.point(point), chain.point(point + 1));
  return wire < this->All.source.wires.size() ? this->All.source.wires[wire].name : "boundary";
}

void FairBorders::place()
{
  this->Positions.clear();
  for (std::size_t v = 0; v < this->All.source.positions.size(); ++v)
  {
    this->Positions.push_back(this->All.at(static_cast<Index>(v)));
  }
  for (std::size_t c = 0; c < this->plan().size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    for (std::size_t k = 0; k < chain.points.size(); ++k)
    {
      this->Positions[static_cast<std::size_t>(chain.points[k])] =
        spanAt(this->spans()[c], chain.arc[k]).at(chain.arc[k]);
    }
  }
}

void FairBorders::report()
{
  this->Reports.assign(this->All.loops.size(), {});
  for (std::size_t c = 0; c < this->plan().size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    FairPieceReport& report = this->Reports[chain.piece];
    report.edges += chain.edges();
    for (const PlannedStretch& stretch : this->plan()[c].stretches)
    {
      const double length = chain.arc[stretch.lastPoint] - chain.arc[stretch.firstPoint];
      std::size_t splines = 0;
      for (std::size_t k = stretch.firstInterval; k < stretch.endInterval; ++k)
      {
        splines += static_cast<std::size_t>(this->plan()[c].intervals[k].spans);
      }
      report.splines += stretch.form == StretchForm::Spline ? splines : 0;
      report.segments += stretch.form == StretchForm::Straight ? 1
        : stretch.form == StretchForm::Raw ? stretch.lastPoint - stretch.firstPoint
                                           : 0;
      report.straightened +=
        stretch.form == StretchForm::Straight && stretch.bend > inexact * length ? 1 : 0;
    }
  }
  Points2 before;
  for (const Point2& p : this->All.source.positions)
  {
    before.emplace_back(this->All.scale() * p);
  }
  for (const LeftStretch& left : this->Fit->left())
  {
    FairPieceReport& report = this->Reports[this->Chains.chains()[left.chain].piece];
    report.wantedOfWorst = left.needed > report.worstLeft ? left.tolerance : report.wantedOfWorst;
    report.worstLeft = std::max(report.worstLeft, left.needed);
    report.left.push_back(this->nameOf(left.chain, left.firstPoint));
  }
  for (std::size_t p = 0; p < this->Reports.size(); ++p)
  {
    FairPieceReport& report = this->Reports[p];
    report.solved = this->Fit->solved(p);
    report.deviation = this->Fit->largestDeviation(p);
    report.strainBefore = strainQuantile(this->All, p, before);
    report.strain = strainQuantile(this->All, p, followBorders(this->All, p, this->Positions));
    std::sort(report.left.begin(), report.left.end());
    report.left.erase(std::unique(report.left.begin(), report.left.end()), report.left.end());
  }
}

std::vector<FairSpan> FairBorders::curveOf(const SourceWire& wire) const
{
  // Runs of edges that follow each other in one chain, so that its splines come whole.
  std::vector<FairSpan> parts;
  ChainEdge run;
  double from = 0.0;
  double to = 0.0;
  bool any = false;
  const auto end = [&] {
    if (any)
    {
      addParts(this->spans()[run.chain], from, to, parts);
    }
    any = false;
  };
  for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
  {
    ChainEdge place;
    this->Chains.find(wire.points[k], wire.points[k + 1], place); // all wires are in chains
    const std::vector<double>& arc = this->Chains.chains()[place.chain].arc;
    const double start = arc[place.edge + (place.backwards ? 1 : 0)];
    if (!any || place.chain != run.chain || place.backwards != run.backwards || start != to)
    {
      end();
      from = start;
    }
    to = arc[place.edge + (place.backwards ? 0 : 1)];
    run = place;
    any = true;
  }
  end();
  return parts;
}

std::vector<FairSpan> FairBorders::alongEdge(
  Index from, Index to, double fromFraction, double toFraction) const
{
  std::vector<FairSpan> parts;
  ChainEdge place;
  if (!this->Chains.find(from, to, place))
  {
    return parts;
  }
  const std::vector<double>& arc = this->Chains.chains()[place.chain].arc;
  const double start = arc[place.edge];
  const double length = arc[place.edge + 1] - start;
  const auto at = [&](double fraction) {
    return start + length * (place.backwards ? 1.0 - fraction : fraction);
  };
  addParts(this->spans()[place.chain], at(fromFraction), at(toFraction), parts);
  return parts;
}
}
}
