// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/ClothOutline.h"

#include "Fairing/FairBorders.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>

namespace flattening::pattern
{
DartPlacement::DartPlacement(const DrawingSource& all, const Indices& loop, const Dart& dart)
  : TwoTips(dart.otherTip != none)
{
  const Index from = loop[dart.firstEdge];
  const Index to = loop[(dart.firstEdge + 1) % loop.size()];
  this->Back = all.valueAlong(from, to, all.options.dartTipOfCurve, all.options.dartTip);
  const Point2 tip = all.at(dart.tip);
  const std::array<Point2, 2> others = this->TwoTips
    ? std::array<Point2, 2>{ tip, all.at(dart.otherTip) }
    : std::array<Point2, 2>{ all.at(dart.mouth[0]), all.at(dart.mouth[1]) };
  this->Middle = (others[0] + others[1]) / 2.0;
  this->Mouth = others[1] - others[0];
  const Point2 way = tip - this->Middle;
  this->Depth = (this->TwoTips ? 2.0 : 1.0) * way.norm();
  this->Inwards = this->Depth > 0.0 ? Point2(way.normalized()) : Point2(Point2::Zero());
  const double width = cross(this->Mouth, this->Inwards);
  if (this->TwoTips || std::abs(width) < 1e-9 * this->Depth)
  {
    this->Mouth = Point2(this->Inwards.y(), -this->Inwards.x()); // along which nothing is between
  }
}

Point2 DartPlacement::at(const Point2& point) const
{
  if (this->Back == 0.0 || this->Depth == 0.0)
  {
    return point;
  }
  const double inwards =
    cross(this->Mouth, point - this->Middle) / cross(this->Mouth, this->Inwards);
  const double share = inwards / (this->TwoTips ? this->Depth / 2.0 : this->Depth);
  return point - share * this->Back * this->Inwards;
}

void DartPlacement::place(PatternLine& leg) const
{
  if (this->Back == 0.0)
  {
    return;
  }
  forEachPoint(leg, [this](Point2& p) { p = this->at(p); });
  leg.restLength = lengthOf(leg);
}

Status DartPlacement::check(const std::string& dart, const std::string& piece) const
{
  if (this->Back <= 0.5 * this->Depth)
  {
    return {};
  }
  return { StatusCode::InvalidOption,
    "the tip of the dart " + dart + " of piece " + piece + " cannot be drawn back by " +
      formatNumber(this->Back, 1) + " mm, since the dart is " + formatNumber(this->Depth, 1) +
      " mm deep",
    {}, { Remedy::CheckUnit, { Remedy::Give, "at most half of its depth" } } };
}

ClothOutline::ClothOutline(const DrawingSource& all, std::size_t piece)
  : All(all)
  , Piece(piece)
  , Loops(all.loops[piece])
  , Darts(all.darts[piece])
{
  for (std::size_t d = 0; d < this->Darts.size(); ++d)
  {
    const Dart& dart = this->Darts[d];
    const Indices& loop = this->Loops[dart.loop];
    this->Placements.emplace_back(all, loop, dart);
    for (std::size_t k = dart.firstEdge; k < dart.firstEdge + dart.edges; ++k)
    {
      this->Folded.emplace(undirectedKey(loop[k % loop.size()], loop[(k + 1) % loop.size()]), d);
    }
  }
}

const DartPlacement* ClothOutline::placementAlong(Index from, Index to) const
{
  const auto found = this->Folded.find(undirectedKey(from, to));
  return found == this->Folded.end() ? nullptr : &this->Placements[found->second];
}

namespace
{
/// A tab on the right of a line, whose ends are cut off at 45 degrees.
Points2 tabAlong(const Points2& line, double width)
{
  std::vector<double> arc(1, 0.0);
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
  {
    arc.push_back(arc.back() + (line[k + 1] - line[k]).norm());
  }
  const double reach = std::min(width, arc.back() / 3.0);
  Points2 tab = line;
  Points2 border;
  const auto add = [&](const Point2& foot, const Point2& along, double distance) {
    border.push_back(foot + distance * Point2(along.y(), -along.x()));
  };
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
  {
    const double length = arc[k + 1] - arc[k];
    if (!(length > 0.0))
    {
      continue;
    }
    const Point2 along = (line[k + 1] - line[k]) / length;
    // Both ends of the edge, and where the slanted ends stop within it.
    for (const double at : { arc[k], reach, arc.back() - reach, arc[k + 1] })
    {
      if (at >= arc[k] && at <= arc[k + 1])
      {
        add(line[k] + (at - arc[k]) * along, along, std::min({ reach, at, arc.back() - at }));
      }
    }
  }
  tab.insert(tab.end(), border.rbegin(), border.rend());
  return tab;
}
}

std::vector<AllowancePolygon> ClothOutline::polygons() const
{
  std::vector<AllowancePolygon> polygons;
  for (std::size_t l = 0; l < this->Loops.size(); ++l)
  {
    const bool isDart = std::any_of(this->Darts.begin(), this->Darts.end(),
      [l](const Dart& dart) { return dart.loop == l && dart.otherTip != none; });
    if (!isDart)
    {
      polygons.push_back(this->polygonOf(l));
    }
  }
  if (this->All.options.glueTab > 0.0 && !polygons.empty())
  {
    polygons.front().tabs = this->glueTabs();
  }
  return polygons;
}

std::vector<Points2> ClothOutline::glueTabs() const
{
  std::vector<Points2> tabs;
  for (const Join& join : this->All.joins)
  {
    Indices points = join.points[0];
    if (join.mark.empty() ||
      pieceOf(this->All.border, points[0], points[1]) != static_cast<Index>(this->Piece))
    {
      continue;
    }
    const bool onLeft = this->All.border.count(edgeKey(points[0], points[1])) > 0;
    if (!onLeft) // the cloth is to be there
    {
      std::reverse(points.begin(), points.end());
    }
    tabs.push_back(tabAlong(drawnLine(this->All, points), this->All.options.glueTab));
  }
  return tabs;
}

AllowancePolygon ClothOutline::polygonOf(std::size_t l) const
{
  const Indices& loop = this->Loops[l];
  const std::size_t count = loop.size();
  const auto point = [&loop, count](std::size_t k) { return loop[k % count]; };
  AllowancePolygon polygon;
  const auto add = [&polygon](const Point2& p, double allowance) {
    polygon.points.push_back(p);
    polygon.allowance.push_back(allowance);
  };
  std::size_t start = 0; // outside the darts
  while (start < count && this->placementAlong(point(start), point(start + 1)))
  {
    ++start;
  }
  for (std::size_t k = start; k < start + count;)
  {
    const auto dart = std::find_if(this->Darts.begin(), this->Darts.end(),
      [&](const Dart& d) { return d.loop == l && d.firstEdge == k % count; });
    if (dart == this->Darts.end())
    {
      Points2 along;
      addDrawnEdge(this->All, point(k), point(k + 1), along);
      for (const Point2& p : along)
      {
        add(p, this->All.allowanceAlong(point(k), point(k + 1)));
      }
      ++k;
      continue;
    }
    const std::size_t end = k + dart->edges;
    const double before = this->All.allowanceAlong(point(k + count - 1), point(k));
    const double after = this->All.allowanceAlong(point(end), point(end + 1));
    const auto at = [&](std::size_t n) { return this->All.at(point(n)); };
    const DartPlacement& placement =
      this->Placements[static_cast<std::size_t>(dart - this->Darts.begin())];
    Point2 corner;
    add(at(k), before);
    if (dartRoof(placement.at(this->All.at(dart->tip)), { at(k), at(end) },
          { at(k + count - 1), at(end + 1) }, corner))
    {
      add(corner, after);
    }
    k = end;
  }
  return polygon;
}
}
