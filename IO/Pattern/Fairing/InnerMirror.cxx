// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/InnerMirror.h"

#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
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
}
}
