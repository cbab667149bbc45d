// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/BorderMarks.h"

#include "Fairing/FairBorders.h"

#include <algorithm>
#include <map>
#include <set>

namespace flattening::pattern
{
namespace
{
struct CurveEnd
{
  std::string name;
  double arcLength = 0.0;
};

/// The ends of all curves but the boundary's, and the places that are sewn to them.
std::map<Index, CurveEnd> curveEnds(const PatternSource& source)
{
  std::map<Index, CurveEnd> ends;
  for (const SourceWire& wire : source.wires)
  {
    if (wire.type == WireType::Boundary || wire.points.size() < 2 ||
      wire.points.front() == wire.points.back())
    {
      continue;
    }
    ends.insert({ wire.points.front(), { wire.name, 0.0 } });
    ends.insert({ wire.points.back(), { wire.name, arcsOnSurface(source, wire.points).back() } });
  }
  const std::map<Index, CurveEnd> own = ends;
  for (const SewnEdges& pair : source.sewn)
  {
    for (std::size_t end = 0; end < 2; ++end)
    {
      for (const auto& [one, other] :
        { std::array{ pair.a[end], pair.b[end] }, std::array{ pair.b[end], pair.a[end] } })
      {
        const auto found = own.find(one);
        if (found != own.end())
        {
          ends.insert({ other, found->second });
        }
      }
    }
  }
  return ends;
}
}

std::vector<BorderMark> findBorderMarks(const DrawingSource& all)
{
  std::vector<BorderMark> marks;
  if (!all.options.notchCorners && !all.options.notchCurveEnds)
  {
    return marks;
  }
  const std::map<Index, CurveEnd> ends = curveEnds(all.source);
  std::set<Index> ofDarts;
  std::size_t borders = 0; // the first of the chains
  for (std::size_t p = 0; p < all.loops.size(); ++p)
  {
    borders += all.loops[p].size();
    for (const Dart& dart : all.darts[p])
    {
      ofDarts.insert({ dart.tip, dart.otherTip, dart.mouth[0], dart.mouth[1] });
    }
  }
  const BorderChains chains(all);
  for (std::size_t c = 0; c < borders; ++c)
  {
    const BorderChain& chain = chains.chains()[c];
    const std::size_t count = chain.points.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      BorderMark mark;
      mark.piece = chain.piece;
      mark.before = chain.point(k + count - 1);
      mark.point = chain.points[k];
      mark.after = chain.point(k + 1);
      mark.corner = chain.turns[k];
      const auto end = ends.find(mark.point);
      const bool isWanted =
        mark.corner ? all.options.notchCorners : all.options.notchCurveEnds && end != ends.end();
      if (!isWanted || ofDarts.count(mark.point) > 0)
      {
        continue;
      }
      if (end != ends.end())
      {
        mark.name = end->second.name;
        mark.arcLength = end->second.arcLength;
      }
      marks.push_back(std::move(mark));
    }
  }
  return marks;
}

namespace
{
/// Of a sew line from the cut line, for a notch to lie between them; millimetres.
constexpr double leastRoom = 0.2;
}

Point2 NotchMarks::onCutLine(const Point2& from, const Point2& direction) const
{
  for (const double at : crossings(from, direction, this->CutLine))
  {
    if (at > -1e-6)
    {
      return from + std::max(at, 0.0) * direction;
    }
  }
  return from;
}

void NotchMarks::add(
  const Point2& foot, const Point2& outward, double arcLength, const std::string& name)
{
  const Point2 from = this->onCutLine(foot, outward);
  const double room = (from - foot).norm();
  // A cut into the allowance stays clear of the seam; without allowance it is a short mark.
  const double most = this->All.options.notchLength;
  const double length = room > leastRoom ? std::min(most, 0.6 * room) : std::min(most, 3.0);
  this->Drawing.notches.push_back({ foot, from, from - length * outward, true, arcLength, name });
}

void NotchMarks::addAcross(
  const Point2& foot, const Point2& outward, double arcLength, const std::string& name)
{
  const Point2 half = std::min(this->All.options.notchLength, 5.0) / 2.0 * outward;
  this->Drawing.notches.push_back({ foot, foot + half, foot - half, false, arcLength, name });
}

void NotchMarks::add(const BorderMark& mark)
{
  Point2 outOfFirst;
  Point2 outOfSecond;
  const Point2 foot = pointOnDrawnEdge(this->All, mark.before, mark.point, 1.0, outOfFirst);
  pointOnDrawnEdge(this->All, mark.point, mark.after, 0.0, outOfSecond);
  const double arcLength = this->All.scale() * mark.arcLength;
  if (!mark.corner || cross(outOfFirst, outOfSecond) <= 0.0)
  {
    this->add(foot, (outOfFirst + outOfSecond).normalized(), arcLength, mark.name);
    return;
  }
  for (const Point2& onwards :
    { Point2(-outOfFirst.y(), outOfFirst.x()), Point2(outOfSecond.y(), -outOfSecond.x()) })
  {
    // Without an allowance the corner is mark enough.
    if ((this->onCutLine(foot, onwards) - foot).norm() > leastRoom)
    {
      this->add(foot, onwards, arcLength, mark.name);
    }
  }
}
}
