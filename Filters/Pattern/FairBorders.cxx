// SPDX-License-Identifier: BSD-3-Clause
#include "FairBorders.h"

#include "FairNetwork.h"
#include "FairStrain.h"
#include "PieceNetwork.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr int rounds = 12;
constexpr int smoothings = 6;
constexpr double widerWave = 1.6;
constexpr double sparing = 0.5;  ///< of the tolerance, what may be spent on smoothness alone
constexpr double inexact = 1e-6; ///< of a stretch: bent by less it is a segment already

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
  , Plan(planFairBorders(all, this->Chains))
  , Spans(this->Plan.size())
  , Deviation(this->Plan.size())
  , Reports(all.loops.size())
{
  this->solve();
  this->place();
  this->report();
}

void FairBorders::solve()
{
  const std::size_t pieces = this->All.loops.size();
  std::vector<double> wave(pieces, 0.0);
  for (std::size_t p = 0; p < pieces; ++p)
  {
    double length = 0.0;
    std::size_t edges = 0;
    for (const BorderChain& chain : this->Chains.chains())
    {
      length += chain.piece == p ? chain.length() : 0.0;
      edges += chain.piece == p ? chain.edges() : 0;
    }
    wave[p] = length / static_cast<double>(std::max<std::size_t>(edges, 1));
  }
  for (int round = 0; round < rounds; ++round)
  {
    agreeOnSpans(this->Plan);
    bool changed = false;
    for (std::size_t p = 0; p < pieces; ++p)
    {
      if (!this->solvePiece(p, wave[p]))
      {
        if (!this->loosen(p))
        {
          this->leave(p);
        }
        changed = true;
        continue;
      }
      changed = this->refine(p, round + 4 > rounds) || changed;
    }
    if (!changed)
    {
      break;
    }
  }
  for (std::size_t p = 0; p < pieces; ++p)
  {
    if (!this->solvePiece(p, wave[p]))
    {
      this->leave(p);
      this->solvePiece(p, wave[p]);
    }
    for (int k = 0; k < smoothings; ++k)
    {
      wave[p] *= widerWave;
      const auto spans = this->Spans;
      const auto deviation = this->Deviation;
      if (!this->solvePiece(p, wave[p]) || this->largestShare(p) > sparing)
      {
        this->Spans = spans;
        this->Deviation = deviation;
        break;
      }
    }
  }
}

bool FairBorders::solvePiece(std::size_t piece, double wave)
{
  const PieceNetwork network(this->All, this->Chains, this->Plan, piece);
  const FairCurves curves = solveFairNetwork(network.network(), wave);
  if (curves.converged)
  {
    network.take(curves, this->Spans, this->Deviation);
  }
  return curves.converged;
}

bool FairBorders::refine(std::size_t piece, bool last)
{
  bool changed = false;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    if (this->Chains.chains()[c].piece == piece)
    {
      for (PlannedStretch& stretch : this->Plan[c].stretches)
      {
        changed = this->refineStretch(c, stretch, last) || changed;
      }
    }
  }
  return changed;
}

bool FairBorders::refineStretch(std::size_t c, PlannedStretch& stretch, bool last)
{
  if (stretch.form == StretchForm::Raw)
  {
    return false;
  }
  double needed = 0.0;
  double wanted = 0.0;
  bool refined = false;
  for (std::size_t k = stretch.firstInterval; k < stretch.endInterval; ++k)
  {
    const double off = this->Deviation[c][k];
    PlannedInterval& interval = this->Plan[c].intervals[k];
    if (off > interval.tolerance)
    {
      wanted = off > needed ? interval.tolerance : wanted;
      needed = std::max(needed, off);
      if (stretch.form == StretchForm::Spline && interval.spans < interval.most && !last)
      {
        ++interval.spans;
        refined = true;
      }
    }
  }
  if (needed == 0.0)
  {
    return false;
  }
  if (!refined && stretch.form == StretchForm::Straight)
  {
    stretch.form = StretchForm::Spline; // lengths beside it have moved it
  }
  else if (!refined)
  {
    stretch.form = StretchForm::Raw;
    FairPieceReport& report = this->Reports[this->Chains.chains()[c].piece];
    report.wantedOfWorst = needed > report.worstLeft ? wanted : report.wantedOfWorst;
    report.worstLeft = std::max(report.worstLeft, needed);
    report.left.push_back(this->nameOf(c, stretch.firstPoint));
  }
  return true;
}

bool FairBorders::loosen(std::size_t piece)
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

void FairBorders::leave(std::size_t piece)
{
  this->Reports[piece].solved = false;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    for (PlannedStretch& stretch : this->Plan[c].stretches)
    {
      stretch.form = this->Chains.chains()[c].piece == piece ? StretchForm::Raw : stretch.form;
    }
  }
}

double FairBorders::largestDeviation(std::size_t piece) const
{
  double most = 0.0;
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    if (this->Chains.chains()[c].piece == piece)
    {
      for (const double deviation : this->Deviation[c])
      {
        most = std::max(most, deviation);
      }
    }
  }
  return most;
}

double FairBorders::largestShare(std::size_t piece) const
{
  double most = 0.0;
  double largest = 0.0; // tolerance, for what stays as it was
  for (const PlannedChain& chain : this->Plan)
  {
    for (const PlannedInterval& interval : chain.intervals)
    {
      largest = std::max(largest, interval.tolerance);
    }
  }
  if (largest == 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    const bool isHere = this->Chains.chains()[c].piece == piece;
    for (std::size_t k = 0; isHere && k < this->Deviation[c].size(); ++k)
    {
      const double own = this->Plan[c].intervals[k].tolerance;
      most = std::max(most, this->Deviation[c][k] / (own > 0.0 ? own : largest));
    }
  }
  return most;
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
  for (std::size_t v = 0; v < this->All.source.positions.size(); ++v)
  {
    this->Positions.push_back(this->All.at(static_cast<Index>(v)));
  }
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    for (std::size_t k = 0; k < chain.points.size(); ++k)
    {
      this->Positions[static_cast<std::size_t>(chain.points[k])] =
        spanAt(this->Spans[c], chain.arc[k]).at(chain.arc[k]);
    }
  }
}

void FairBorders::report()
{
  for (std::size_t c = 0; c < this->Plan.size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    FairPieceReport& report = this->Reports[chain.piece];
    report.edges += chain.edges();
    for (const PlannedStretch& stretch : this->Plan[c].stretches)
    {
      const double length = chain.arc[stretch.lastPoint] - chain.arc[stretch.firstPoint];
      std::size_t splines = 0;
      for (std::size_t k = stretch.firstInterval; k < stretch.endInterval; ++k)
      {
        splines += static_cast<std::size_t>(this->Plan[c].intervals[k].spans);
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
  for (std::size_t p = 0; p < this->Reports.size(); ++p)
  {
    FairPieceReport& report = this->Reports[p];
    report.deviation = this->largestDeviation(p);
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
      addParts(this->Spans[run.chain], from, to, parts);
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
  addParts(this->Spans[place.chain], at(fromFraction), at(toFraction), parts);
  return parts;
}
}
}
