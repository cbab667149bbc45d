// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/OutlineMirror.h"

#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace pattern
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
        this->Mirror.stretches.push_back(
          { { this->Mirror.chain, one }, { this->Mirror.chain, other }, true });
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

std::vector<double> mirroredBreaks(
  const std::vector<double>& breaks, double start, double end, bool backwards)
{
  const double first = breaks.front();
  const double last = breaks.back();
  std::vector<double> image;
  for (const double at : breaks)
  {
    image.push_back(start + (backwards ? last - at : at - first) / (last - first) * (end - start));
  }
  if (backwards)
  {
    std::reverse(image.begin(), image.end());
  }
  image.front() = start;
  image.back() = end;
  return image;
}

void mirrorPlan(const OutlineMirror& mirror, std::vector<PlannedChain>& plan)
{
  for (const MirroredStretches& pair : mirror.stretches)
  {
    PlannedStretch& one = plan[pair.one.chain].stretches[pair.one.stretch];
    PlannedStretch& other = plan[pair.other.chain].stretches[pair.other.stretch];
    for (PlannedStretch* const stretch : { &one, &other })
    {
      // One edge is straight however it is meant.
      stretch->form = stretch->form == StretchForm::Raw ? StretchForm::Straight : stretch->form;
    }
    const bool straight = one.form == StretchForm::Straight && other.form == StretchForm::Straight;
    one.form = other.form = straight ? StretchForm::Straight : StretchForm::Spline;
    if (pair.own() && !pair.backwards)
    {
      continue; // on the axis
    }
    addBreaks(mirroredBreaks(other.breaks, one.breaks.front(), one.breaks.back(), pair.backwards),
      one.breaks);
    if (pair.own())
    {
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
      continue;
    }
    other.breaks =
      mirroredBreaks(one.breaks, other.breaks.front(), other.breaks.back(), pair.backwards);
  }
}

double missOfCurves(
  const OutlineMirror& mirror, const PlannedChain& chain, const std::vector<FairSpan>& spans)
{
  double miss = 0.0;
  for (const MirroredStretches& pair : mirror.stretches)
  {
    if (pair.one.chain != mirror.chain)
    {
      continue;
    }
    const std::vector<FairSpan> one = spansOf(spans, chain.stretches[pair.one.stretch]);
    std::vector<FairSpan> other = spansOf(spans, chain.stretches[pair.other.stretch]);
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
}
}
