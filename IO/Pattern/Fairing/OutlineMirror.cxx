// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/OutlineMirror.h"

#include "Outlines/PatternText.h"
#include "Outlines/PlaneGeometry.h"

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

namespace
{
/// Of chords from what is drawn: millimetres, and of all that is drawn.
constexpr double fineSamples = 1e-3;
constexpr double fineShare = 1e-6;

/// How far the image of a point is from lines, at most.
double missOf(const Points2& points, const MirrorAxis& axis, const Segments& lines)
{
  double miss = 0.0;
  for (const Point2& p : points)
  {
    miss = std::max(miss, distance(imageOf(p, axis), lines));
  }
  return miss;
}

Points2 meshPoints(const DrawingSource& all, const BorderChain& chain)
{
  Points2 points;
  for (const Index v : chain.points)
  {
    points.push_back(all.at(v));
  }
  return points;
}

Points2 drawnPoints(const std::vector<FairSpan>& spans, double distance)
{
  Points2 points;
  for (const FairSpan& span : spans)
  {
    sampleSpan(span, distance, points);
  }
  points.push_back(spans.back().control[3]);
  return points;
}

/// Looks for the images of the stretches within a piece.
class ImageSearch
{
public:
  ImageSearch(const DrawingSource& all, const BorderChains& chains,
    const std::vector<PlannedChain>& plan, const OutlineMirror& mirror)
    : All(all)
    , Chains(chains)
    , Plan(plan)
    , Mirror(mirror)
  {
    for (std::size_t c = 0; c < plan.size(); ++c)
    {
      const bool within =
        c != mirror.chain && chains.chains()[c].piece == chains.chains()[mirror.chain].piece;
      for (std::size_t s = 0; within && s < plan[c].stretches.size(); ++s)
      {
        const PlannedStretch& stretch = plan[c].stretches[s];
        const bool raw = stretch.form == StretchForm::Raw && stretch.edges() > 1;
        if (!raw && !stretch.smoothEnds)
        {
          this->Places.push_back({ c, s });
          this->Points.push_back(this->pointsOf({ c, s }));
        }
      }
    }
  }

  std::vector<MirroredStretches> find() const
  {
    std::vector<MirroredStretches> pairs;
    std::vector<bool> taken(this->Places.size(), false);
    for (std::size_t a = 0; a < this->Places.size(); ++a)
    {
      for (std::size_t b = a; b < this->Places.size() && !taken[a]; ++b)
      {
        for (const bool backwards : { true, false })
        {
          if (!taken[a] && !taken[b] && this->areImages(a, b, backwards))
          {
            taken[a] = taken[b] = true;
            pairs.push_back({ this->Places[a], this->Places[b], backwards });
          }
        }
      }
    }
    return pairs;
  }

private:
  const PlannedStretch& at(std::size_t k) const
  {
    return this->Plan[this->Places[k].chain].stretches[this->Places[k].stretch];
  }

  Points2 pointsOf(const StretchPlace& place) const
  {
    const PlannedStretch& stretch = this->Plan[place.chain].stretches[place.stretch];
    Points2 points;
    for (std::size_t k = stretch.firstPoint; k <= stretch.lastPoint; ++k)
    {
      points.push_back(this->All.at(this->Chains.chains()[place.chain].point(k)));
    }
    return points;
  }

  double lengthOf(std::size_t k) const
  {
    const std::vector<double>& arc = this->Chains.chains()[this->Places[k].chain].arc;
    return arc[this->at(k).lastPoint] - arc[this->at(k).firstPoint];
  }

  bool areImages(std::size_t a, std::size_t b, bool backwards) const
  {
    const Points2& one = this->Points[a];
    const Points2& other = this->Points[b];
    const Point2& start = backwards ? other.back() : other.front();
    const Point2& end = backwards ? other.front() : other.back();
    if ((imageOf(one.front(), this->Mirror.axis) - start).norm() > 2.0 * mirrorTolerance ||
      (imageOf(one.back(), this->Mirror.axis) - end).norm() > 2.0 * mirrorTolerance)
    {
      return false;
    }
    if (a == b && !backwards && this->at(a).form != StretchForm::Straight)
    {
      return false; // what is on the axis is straight
    }
    Segments lines;
    Segments otherLines;
    addSegments(one, false, lines);
    addSegments(other, false, otherLines);
    return missOf(one, this->Mirror.axis, otherLines) <= mirrorTolerance &&
      missOf(other, this->Mirror.axis, lines) <= mirrorTolerance &&
      std::abs(this->lengthOf(a) - this->lengthOf(b)) <= mirroredLengthTolerance;
  }

  const DrawingSource& All;
  const BorderChains& Chains;
  const std::vector<PlannedChain>& Plan;
  const OutlineMirror& Mirror;
  std::vector<StretchPlace> Places;
  std::vector<Points2> Points;
};
}

void findInnerMirror(const DrawingSource& all, const BorderChains& chains,
  const std::vector<PlannedChain>& plan, OutlineMirror& mirror)
{
  if (mirror.found())
  {
    const std::vector<MirroredStretches> within = ImageSearch(all, chains, plan, mirror).find();
    mirror.stretches.insert(mirror.stretches.end(), within.begin(), within.end());
  }
}

InnerMirror measureInnerMirror(const DrawingSource& all, const BorderChains& chains,
  const std::vector<std::vector<FairSpan>>& spans, std::size_t outline, const MirrorAxis& axis)
{
  std::vector<std::size_t> inner;
  Segments lines;
  for (std::size_t c = 0; c < chains.chains().size(); ++c)
  {
    const BorderChain& chain = chains.chains()[c];
    if (c != outline && chain.piece == chains.chains()[outline].piece)
    {
      inner.push_back(c);
      addSegments(meshPoints(all, chain), chain.closed, lines);
    }
  }
  const auto hasNoImage = [&](std::size_t c) {
    return missOf(meshPoints(all, chains.chains()[c]), axis, lines) > mirrorTolerance;
  };
  inner.erase(std::remove_if(inner.begin(), inner.end(), hasNoImage), inner.end());
  InnerMirror mirror;
  mirror.curves = inner.size();
  double length = 0.0;
  for (const std::size_t c : inner)
  {
    length += chains.chains()[c].length();
  }
  std::vector<Points2> drawn;
  lines.clear();
  for (const std::size_t c : inner)
  {
    drawn.push_back(drawnPoints(spans[c], std::max(fineSamples, fineShare * length)));
    addSegments(drawn.back(), false, lines);
  }
  for (std::size_t k = 0; k < inner.size(); ++k)
  {
    const double miss = missOf(drawn[k], axis, lines);
    if (miss > mirror.miss)
    {
      mirror.miss = miss;
      const BorderChain& chain = chains.chains()[inner[k]];
      mirror.worst = all.nameAlong(chain.point(0), chain.point(1));
    }
  }
  return mirror;
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
        PlannedChain& one = plan[pair.one.chain];
        PlannedChain& other = plan[pair.other.chain];
        const double length = lengthOf(one, pair.one.stretch);
        const double mean = (length + lengthOf(other, pair.other.stretch)) / 2.0;
        if (!pair.own() && mean != length)
        {
          change = std::max(change, std::abs(mean / length - 1.0));
          scale(other, pair.other.stretch, mean / (2.0 * mean - length));
          scale(one, pair.one.stretch, mean / length);
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
}
