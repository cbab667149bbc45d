// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/OutlineMirror.h"

#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening::pattern
{
namespace
{
constexpr double sameCorner = 2.0 * mirrorTolerance; ///< of a corner from another's image
constexpr double knownBreak = 1e-6;                  ///< of a stretch

class MirrorSearch
{
public:
  MirrorSearch(const DrawingSource& all, const BorderChain& chain,
    const std::vector<PlannedStretch>& stretches, OutlineMirror& mirror)
    : All(all)
    , Chain(chain)
    , Stretches(stretches)
    , Mirror(mirror)
  {
  }

  void find()
  {
    if (this->Mirror.axis.miss > mirrorTolerance)
    {
      this->Mirror.why = "mirrored, it misses itself by " +
        formatNumber(this->Mirror.axis.miss, 2) + " mm, more than " +
        formatNumber(mirrorTolerance, 1) + " mm";
      return;
    }
    if (this->Stretches.front().smoothEnds)
    {
      this->Mirror.why = "its outline has no corner";
      return;
    }
    std::vector<std::size_t> image; // of the corner at which a stretch starts
    for (const PlannedStretch& stretch : this->Stretches)
    {
      image.push_back(this->imageOfCorner(stretch.firstPoint));
    }
    std::vector<std::array<std::size_t, 2>> pairs;
    const std::size_t count = this->Stretches.size();
    for (std::size_t s = 0; s < count; ++s)
    {
      const std::size_t other = image[(s + 1) % count];
      if (other == count || image[s] == count || (other + 1) % count != image[s])
      {
        const bool first = image[s] == count;
        this->Mirror.why = "the corner at the " + std::string(first ? "start" : "end") + " of " +
          this->nameOf(s) + " has no counterpart within " + formatNumber(sameCorner, 1) + " mm";
        return;
      }
      if (s <= other)
      {
        pairs.push_back({ s, other });
      }
    }
    if (this->areAlike(pairs))
    {
      for (const auto& [one, other] : pairs)
      {
        this->Mirror.stretches.push_back({ one, other });
      }
    }
  }

private:
  Point2 at(std::size_t point) const { return this->All.at(this->Chain.point(point)); }

  double lengthOf(std::size_t s) const
  {
    const PlannedStretch& stretch = this->Stretches[s];
    return this->Chain.arc[stretch.lastPoint] - this->Chain.arc[stretch.firstPoint];
  }

  std::string nameOf(std::size_t s) const
  {
    const std::size_t point = this->Stretches[s].firstPoint;
    return this->All.nameAlong(this->Chain.point(point), this->Chain.point(point + 1));
  }

  std::size_t imageOfCorner(std::size_t point) const
  {
    const Point2 image = imageOf(this->at(point), this->Mirror.axis);
    std::size_t nearest = this->Stretches.size();
    double least = sameCorner;
    for (std::size_t s = 0; s < this->Stretches.size(); ++s)
    {
      const double distance = (this->at(this->Stretches[s].firstPoint) - image).norm();
      if (distance <= least)
      {
        least = distance;
        nearest = s;
      }
    }
    return nearest;
  }

  bool areAlike(const std::vector<std::array<std::size_t, 2>>& pairs)
  {
    for (const auto& [one, other] : pairs)
    {
      for (const std::size_t s : { one, other })
      {
        if (this->Stretches[s].form == StretchForm::Raw && this->Stretches[s].edges() > 1)
        {
          this->Mirror.why = this->nameOf(s) + " stays as the mesh has it";
          return false;
        }
      }
      const double difference = std::abs(this->lengthOf(one) - this->lengthOf(other));
      if (difference > mirroredLengthTolerance)
      {
        this->Mirror.why = "stretches of " + this->nameOf(one) + " and " + this->nameOf(other) +
          " that are mirror images differ by " + formatNumber(difference, 2) +
          " mm in length, more than " + formatNumber(mirroredLengthTolerance, 1) + " mm";
        return false;
      }
      this->Mirror.difference = std::max(this->Mirror.difference, difference);
    }
    return true;
  }

  const DrawingSource& All;
  const BorderChain& Chain;
  const std::vector<PlannedStretch>& Stretches;
  OutlineMirror& Mirror;
};

void addBreaks(const std::vector<double>& more, std::vector<double>& breaks)
{
  const double least = knownBreak * (breaks.back() - breaks.front());
  for (const double at : more)
  {
    const auto next = std::lower_bound(breaks.begin(), breaks.end(), at);
    const bool known = (next != breaks.end() && *next - at < least) ||
      (next != breaks.begin() && at - *(next - 1) < least);
    if (!known)
    {
      breaks.insert(next, at);
    }
  }
}

void setImage(const MirrorAxis& axis, FairSpan& span)
{
  std::reverse(span.control.begin(), span.control.end());
  for (Point2& p : span.control)
  {
    p = imageOf(p, axis);
  }
}

std::vector<FairSpan> spansOf(const std::vector<FairSpan>& spans, const PlannedStretch& stretch)
{
  std::vector<FairSpan> own;
  for (const FairSpan& span : spans)
  {
    const double middle = (span.from + span.to) / 2.0;
    if (middle > stretch.breaks.front() && middle < stretch.breaks.back())
    {
      own.push_back(span);
    }
  }
  return own;
}
}

OutlineMirror findOutlineMirror(const DrawingSource& all, const BorderChains& chains,
  const std::vector<PlannedChain>& plan, std::size_t piece)
{
  OutlineMirror mirror;
  PieceShape shape;
  for (const Index v : all.loops[piece].front())
  {
    shape.outline.push_back(all.at(v));
  }
  mirror.axis = nearestMirrorAxis(shape, mirrorTolerance);
  ChainEdge place;
  chains.find(all.loops[piece].front()[0], all.loops[piece].front()[1], place); // loops are chains
  mirror.chain = place.chain;
  MirrorSearch(all, chains.chains()[place.chain], plan[place.chain].stretches, mirror).find();
  return mirror;
}

std::vector<double> mirroredBreaks(const std::vector<double>& breaks, double start, double end)
{
  const double first = breaks.front();
  const double last = breaks.back();
  std::vector<double> image;
  for (auto at = breaks.rbegin(); at != breaks.rend(); ++at)
  {
    image.push_back(start + (last - *at) / (last - first) * (end - start));
  }
  image.front() = start;
  image.back() = end;
  return image;
}

void mirrorPlan(const OutlineMirror& mirror, std::vector<PlannedChain>& plan)
{
  for (const MirroredStretches& pair : mirror.stretches)
  {
    PlannedStretch& one = plan[mirror.chain].stretches[pair.one];
    PlannedStretch& other = plan[mirror.chain].stretches[pair.other];
    for (PlannedStretch* const stretch : { &one, &other })
    {
      // One edge is straight however it is meant.
      stretch->form = stretch->form == StretchForm::Raw ? StretchForm::Straight : stretch->form;
    }
    const bool straight = one.form == StretchForm::Straight && other.form == StretchForm::Straight;
    one.form = other.form = straight ? StretchForm::Straight : StretchForm::Spline;
    addBreaks(mirroredBreaks(other.breaks, one.breaks.front(), one.breaks.back()), one.breaks);
    if (!pair.own())
    {
      other.breaks = mirroredBreaks(one.breaks, other.breaks.front(), other.breaks.back());
      continue;
    }
    // Those of the first half, exactly.
    const double sum = one.breaks.front() + one.breaks.back();
    for (std::size_t k = one.breaks.size() - 1; 2 * k + 1 > one.breaks.size(); --k)
    {
      one.breaks[k] = sum - one.breaks[one.breaks.size() - 1 - k];
    }
    if (one.breaks.size() % 2 == 1)
    {
      one.breaks[one.breaks.size() / 2] = sum / 2.0;
    }
  }
}

double missOfCurves(
  const OutlineMirror& mirror, const PlannedChain& chain, const std::vector<FairSpan>& spans)
{
  double miss = 0.0;
  for (const MirroredStretches& pair : mirror.stretches)
  {
    const std::vector<FairSpan> one = spansOf(spans, chain.stretches[pair.one]);
    std::vector<FairSpan> other = spansOf(spans, chain.stretches[pair.other]);
    std::reverse(other.begin(), other.end());
    if (one.size() != other.size())
    {
      return std::numeric_limits<double>::infinity();
    }
    for (std::size_t k = 0; k < one.size(); ++k)
    {
      setImage(mirror.axis, other[k]);
      for (std::size_t c = 0; c < 4; ++c)
      {
        miss = std::max(miss, (one[k].control[c] - other[k].control[c]).norm());
      }
    }
  }
  return miss;
}

namespace
{
constexpr double enough = 4.0 * std::numeric_limits<double>::epsilon();
constexpr int projections = 1000;

/// Two intervals that are sewn to each other.
struct Sewn
{
  PlannedInterval* one = nullptr;
  PlannedInterval* other = nullptr;
  double ratio = 1.0; ///< of their lengths, which differ where one is eased
  bool holds = false; ///< the first keeps its length
};

bool isRaw(const PlannedChain& chain, std::size_t interval)
{
  const auto found = std::find_if(chain.stretches.begin(), chain.stretches.end(),
    [interval](const PlannedStretch& stretch) { return interval < stretch.endInterval; });
  return found != chain.stretches.end() && found->form == StretchForm::Raw;
}

std::vector<Sewn> sewnIntervals(std::vector<PlannedChain>& plan)
{
  std::vector<Sewn> sewn;
  for (std::size_t c = 0; c < plan.size(); ++c)
  {
    for (std::size_t k = 0; k < plan[c].intervals.size(); ++k)
    {
      const std::array<std::size_t, 2> own{ c, k };
      const std::array<std::size_t, 2> partner = plan[c].intervals[k].partner;
      if (partner[0] == PlannedInterval::none ||
        plan[partner[0]].intervals[partner[1]].partner != own)
      {
        continue;
      }
      const bool holds = isRaw(plan[c], k);
      const bool otherHolds = isRaw(plan[partner[0]], partner[1]);
      if (holds ? !otherHolds : !otherHolds && own < partner)
      {
        PlannedInterval& one = plan[c].intervals[k];
        PlannedInterval& other = plan[partner[0]].intervals[partner[1]];
        sewn.push_back({ &one, &other, one.length / other.length, holds });
      }
    }
  }
  return sewn;
}

double lengthOf(const PlannedChain& chain, std::size_t s)
{
  double length = 0.0;
  for (std::size_t k = chain.stretches[s].firstInterval; k < chain.stretches[s].endInterval; ++k)
  {
    length += chain.intervals[k].length;
  }
  return length;
}

void scale(PlannedChain& chain, std::size_t s, double factor)
{
  for (std::size_t k = chain.stretches[s].firstInterval; k < chain.stretches[s].endInterval; ++k)
  {
    chain.intervals[k].length *= factor;
  }
}
}

void equalizeMirroredLengths(
  const std::vector<OutlineMirror>& mirrors, std::vector<PlannedChain>& plan)
{
  const bool any = std::any_of(
    mirrors.begin(), mirrors.end(), [](const OutlineMirror& mirror) { return mirror.found(); });
  const std::vector<Sewn> sewn = any ? sewnIntervals(plan) : std::vector<Sewn>();
  double change = any ? 1.0 : 0.0;
  // Projections onto one condition after the other come to lengths that meet all of them. S.
  // Kaczmarz, Angenaeherte Aufloesung von Systemen linearer Gleichungen, 1937.
  for (int round = 0; round < projections && change > enough; ++round)
  {
    change = 0.0;
    for (const OutlineMirror& mirror : mirrors)
    {
      for (const MirroredStretches& pair : mirror.stretches)
      {
        PlannedChain& chain = plan[mirror.chain];
        const double length = lengthOf(chain, pair.one);
        const double mean = (length + lengthOf(chain, pair.other)) / 2.0;
        if (!pair.own() && mean != length)
        {
          change = std::max(change, std::abs(mean / length - 1.0));
          scale(chain, pair.other, mean / (2.0 * mean - length));
          scale(chain, pair.one, mean / length);
        }
      }
    }
    for (const Sewn& pair : sewn)
    {
      const double one = pair.one->length;
      const double wanted = pair.holds ? one : (one + pair.ratio * pair.other->length) / 2.0;
      change = std::max(change, std::abs(wanted / one - 1.0));
      pair.one->length = wanted;
      pair.other->length = wanted / pair.ratio;
    }
  }
}
}
