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

/// The outline of a piece from corner to corner.
struct Outline
{
  const DrawingSource& all;
  const BorderChain& chain;
  const std::vector<PlannedStretch>& stretches;

  std::string nameOf(std::size_t s) const
  {
    return this->chain.nameOf(this->all, this->stretches[s].firstPoint);
  }

  double lengthOf(std::size_t s) const
  {
    return this->chain.arc[this->stretches[s].lastPoint] -
      this->chain.arc[this->stretches[s].firstPoint];
  }

  /// The stretch that starts nearest to the image of the corner at which another does, or their
  /// number.
  std::size_t imageOfStart(std::size_t s, const MirrorAxis& axis) const
  {
    const auto corner = [this](const PlannedStretch& stretch) {
      return this->all.at(this->chain.point(stretch.firstPoint));
    };
    const Point2 image = imageOf(corner(this->stretches[s]), axis);
    std::size_t nearest = this->stretches.size();
    double least = sameCorner;
    for (std::size_t other = 0; other < this->stretches.size(); ++other)
    {
      const double distance = (corner(this->stretches[other]) - image).norm();
      nearest = distance <= least ? other : nearest;
      least = std::min(least, distance);
    }
    return nearest;
  }
};

/// Pairs stretches that are mirror images, and finds by how much their lengths differ. \return why
/// they are none; empty: they are
std::string pairStretches(const Outline& outline, OutlineMirror& mirror)
{
  if (mirror.axis.miss > mirrorTolerance)
  {
    return "mirrored, it misses itself by " + formatNumber(mirror.axis.miss, 2) +
      " mm, more than " + formatNumber(mirrorTolerance, 1) + " mm";
  }
  if (outline.stretches.front().smoothEnds)
  {
    return "its outline has no corner";
  }
  const std::size_t count = outline.stretches.size();
  std::vector<std::size_t> image;
  for (std::size_t s = 0; s < count; ++s)
  {
    image.push_back(outline.imageOfStart(s, mirror.axis));
  }
  for (std::size_t s = 0; s < count; ++s)
  {
    const std::size_t other = image[(s + 1) % count];
    if (other == count || image[s] == count || (other + 1) % count != image[s])
    {
      return "the corner at the " + std::string(image[s] == count ? "start" : "end") + " of " +
        outline.nameOf(s) + " has no counterpart within " + formatNumber(sameCorner, 1) + " mm";
    }
    if (outline.stretches[s].form == StretchForm::Raw && outline.stretches[s].edges() > 1)
    {
      return outline.nameOf(s) + " stays as the mesh has it";
    }
    const double difference = std::abs(outline.lengthOf(s) - outline.lengthOf(other));
    if (difference > mirroredLengthTolerance)
    {
      return "stretches of " + outline.nameOf(s) + " and " + outline.nameOf(other) +
        " that are mirror images differ by " + formatNumber(difference, 2) +
        " mm in length, more than " + formatNumber(mirroredLengthTolerance, 1) + " mm";
    }
    mirror.difference = std::max(mirror.difference, difference);
    if (s <= other)
    {
      mirror.stretches.push_back({ s, other });
    }
  }
  return {};
}

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
      const bool holds = stretchOf(plan[c], k).form == StretchForm::Raw;
      const bool otherHolds = stretchOf(plan[partner[0]], partner[1]).form == StretchForm::Raw;
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

OutlineMirror findOutlineMirror(const DrawingSource& all, const BorderChains& chains,
  const std::vector<PlannedChain>& plan, std::size_t piece)
{
  OutlineMirror mirror;
  const Indices& loop = all.loops[piece].front();
  mirror.axis = nearestMirrorAxis({ all.at(loop), {} }, mirrorTolerance);
  mirror.chain = chains.find(loop[0], loop[1])->chain; // loops are chains
  mirror.why =
    pairStretches({ all, chains.chains()[mirror.chain], plan[mirror.chain].stretches }, mirror);
  if (!mirror.why.empty())
  {
    mirror.stretches.clear();
  }
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
