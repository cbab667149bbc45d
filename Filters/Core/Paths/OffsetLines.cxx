// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetLines.h"

#include "Base/Types.h"
#include "Paths/OffsetWindow.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
/// Stretches of a track by where along it they begin and end.
using TrackParts = std::vector<SegmentPart>;

/// Where a window ends: a line at the distance of a strip, or an arc round the apex of a sector, in
/// the order of the path, which is on its right.
class OffsetTrack
{
public:
  explicit OffsetTrack(const OffsetWindow& window);

  /// As lengths of a line, and angles of an arc, clockwise.
  const SegmentPart& whole() const { return this->Whole; }
  bool isArc() const { return this->Radius > 0.0; }
  double radius() const { return this->Radius; }
  Point2 at(double along) const;
  /// Where tangents at two places of an arc meet.
  Point2 tangentsMeet(double from, double to) const;

  /// Where gradient.dot(place) + constant is not negative.
  TrackParts where(const Point2& gradient, double constant) const;
  TrackParts inDisc(const Point2& center, double radius) const;

private:
  SegmentPart Whole;
  Point2 Origin; ///< of a line; centre of an arc
  Point2 Way;
  double Radius = 0.0; ///< 0: a line
};

TrackParts intersection(const TrackParts& a, const TrackParts& b)
{
  TrackParts parts;
  for (const SegmentPart& one : a)
  {
    for (const SegmentPart& other : b)
    {
      const SegmentPart part{ std::max(one.from, other.from), std::min(one.to, other.to) };
      if (part.to > part.from)
      {
        parts.push_back(part);
      }
    }
  }
  return parts;
}

/// What is left of the first ones, in order.
OffsetTrack::OffsetTrack(const OffsetWindow& window)
  : Origin(window.apex)
{
  if (window.strip)
  {
    this->Origin += window.reach * window.normal;
    this->Way = Point2(window.normal.y(), -window.normal.x());
    this->Whole = { this->Way.dot(window.left - this->Origin),
      this->Way.dot(window.right - this->Origin) };
    return;
  }
  this->Radius = window.reach;
  const double right = std::atan2(window.rightWay.y(), window.rightWay.x());
  const double span =
    std::atan2(cross(window.rightWay, window.leftWay), window.rightWay.dot(window.leftWay));
  this->Whole = { -right - span, -right };
}

Point2 OffsetTrack::at(double along) const
{
  return this->isArc()
    ? Point2(this->Origin + this->Radius * Point2(std::cos(along), -std::sin(along)))
    : Point2(this->Origin + along * this->Way);
}

Point2 OffsetTrack::tangentsMeet(double from, double to) const
{
  const double half = 0.5 * (to - from);
  return this->Origin + (this->at(from + half) - this->Origin) / std::cos(half);
}

TrackParts OffsetTrack::where(const Point2& gradient, double constant) const
{
  const double atOrigin = gradient.dot(this->Origin) + constant;
  TrackParts parts;
  const auto add = [&](double from, double to) {
    const SegmentPart part{ std::max(from, this->Whole.from), std::min(to, this->Whole.to) };
    if (part.to > part.from)
    {
      parts.push_back(part);
    }
  };
  if (!this->isArc())
  {
    const double rate = gradient.dot(this->Way);
    if (rate == 0.0)
    {
      return atOrigin < 0.0 ? parts : TrackParts{ this->Whole };
    }
    const double zero = -atOrigin / rate;
    rate > 0.0 ? add(zero, this->Whole.to) : add(this->Whole.from, zero);
    return parts;
  }
  const double most = this->Radius * gradient.norm();
  if (atOrigin >= most || atOrigin < -most)
  {
    return atOrigin < 0.0 ? parts : TrackParts{ this->Whole };
  }
  const double half = std::acos(-atOrigin / most);
  const double middle = -std::atan2(gradient.y(), gradient.x());
  const double first = std::ceil((this->Whole.from - middle - half) / (2.0 * pi));
  for (double turn = middle + 2.0 * pi * first; turn - half < this->Whole.to; turn += 2.0 * pi)
  {
    add(turn - half, turn + half);
  }
  return parts;
}

TrackParts OffsetTrack::inDisc(const Point2& center, double radius) const
{
  const Point2 way = center - this->Origin;
  if (this->isArc())
  {
    const double apart = way.norm();
    const double more = (radius - this->Radius) * (radius + this->Radius);
    const Point2 gradient = way / apart;
    return this->where(gradient, 0.5 * (more / apart - apart) - gradient.dot(this->Origin));
  }
  const double aside = std::abs(cross(this->Way, way));
  if (!(aside < radius))
  {
    return {};
  }
  const double half = std::sqrt((radius - aside) * (radius + aside));
  const double middle = this->Way.dot(way);
  return intersection({ { middle - half, middle + half } }, { this->Whole });
}

TrackParts difference(const TrackParts& a, const TrackParts& b)
{
  TrackParts left = a;
  for (const SegmentPart& gone : b)
  {
    TrackParts rest;
    for (const SegmentPart& part : left)
    {
      const SegmentPart before{ part.from, std::min(part.to, gone.from) };
      const SegmentPart after{ std::max(part.from, gone.to), part.to };
      for (const SegmentPart& kept : { before, after })
      {
        if (kept.to > kept.from)
        {
          rest.push_back(kept);
        }
      }
    }
    left = std::move(rest);
  }
  return left;
}

/// What is nearer by this fraction of the distance is, beyond rounding.
constexpr double rounding = 1e-11;
/// Windows that touch leave no gap between them; as a fraction of the distance.
constexpr double touching = 1e-12;
/// Lines whose directions differ by less, as an angle, and arcs whose centres differ by less, as a
/// fraction of the distance, may be one and the same.
constexpr double sameTrack = 1e-7;
constexpr double sameCentre = 1e-9;
constexpr double atSide = 1e-12; // of a triangle's height
/// Between the points at which tangents touch an arc; and how often that is halved at most, where
/// they meet beyond the triangle.
constexpr double widestArc = 4.0 * pi / 180.0;
constexpr int halvings = 6;
/// Where rounding would decide how often: parts of an arc, and of a triangle's side.
constexpr double equalArcs = 1e-9;
constexpr double besideTriangle = 1e-9;
/// Ends of lines nearer to each other, as a fraction of the distance, are one; and of the greatest
/// coordinate, for those far from the origin.
constexpr double sameEnd = 1e-7;
constexpr double ofCoordinates = 1e-14;
constexpr double shortest = 1e-6;

/// The windows of one triangle.
class TriangleLines
{
public:
  TriangleLines(const TriangleMesh& mesh, const std::vector<OffsetWindow>& windows,
    const std::vector<std::size_t>& here, double distance)
    : Mesh(mesh)
    , Windows(windows)
    , Here(here)
    , Distance(distance)
    , Touch(touching * distance)
    , Flat(mesh, windows[here.front()].triangle)
  {
  }

  /// What is left of where a window ends.
  void add(std::size_t id, std::vector<OffsetLine>& lines) const
  {
    const OffsetWindow& window = this->Windows[id];
    const OffsetTrack track(window);
    TrackParts left = this->inTriangle(window, track);
    for (std::size_t k = 0; k < this->Here.size() && !left.empty(); ++k)
    {
      if (this->Here[k] != id)
      {
        left = difference(left, this->nearerIn(this->Here[k], id, track));
      }
    }
    std::sort(left.begin(), left.end(),
      [](const SegmentPart& a, const SegmentPart& b) { return a.from < b.from; });
    for (const SegmentPart& part : left)
    {
      if ((part.to - part.from) * (track.isArc() ? track.radius() : 1.0) > this->Touch)
      {
        lines.push_back(this->drawn(track, part));
      }
    }
  }

private:
  TrackParts inTriangle(const OffsetWindow& window, const OffsetTrack& track) const
  {
    TrackParts parts{ track.whole() };
    for (Index k = 0; k < 3 && !parts.empty(); ++k)
    {
      const Point2& corner = this->Flat.corner(k);
      const Point2 side = (this->Flat.corner(k + 1) - corner).normalized();
      // A line along a side is that of the triangle between it and the path.
      if (window.strip && std::abs(side.dot(window.normal)) < sameTrack &&
        std::abs(window.away(corner) - window.reach) <= this->Touch)
      {
        if (window.away(this->Flat.corner(k + 2)) > window.reach)
        {
          return {};
        }
        continue;
      }
      parts = intersection(parts, track.where(Point2(-side.y(), side.x()), -cross(side, corner)));
    }
    return parts;
  }

  /// Where another window's end is farther away.
  TrackParts nearerIn(std::size_t otherId, std::size_t id, const OffsetTrack& track) const
  {
    const OffsetWindow& window = this->Windows[id];
    const OffsetWindow& other = this->Windows[otherId];
    const double sooner = (other.own && otherId < id ? -rounding : rounding) * this->Distance;
    // Where they cross, both end in one place. Of those that are one and the same the first is
    // left.
    bool same = false;
    TrackParts parts;
    if (other.strip)
    {
      same = window.strip && window.normal.dot(other.normal) > 0.0 &&
        std::abs(cross(window.normal, other.normal)) < sameTrack;
      parts = track.where(
        -other.normal, other.normal.dot(other.apex) + other.reach - (same ? sooner : 0.0));
      parts = intersection(parts, track.where(other.normal, -other.normal.dot(other.apex)));
    }
    else if (!window.strip && (window.apex - other.apex).norm() <= sameCentre * this->Distance)
    {
      same = true;
      parts = other.reach - window.reach > sooner ? TrackParts{ track.whole() } : TrackParts();
    }
    else
    {
      parts = track.inDisc(other.apex, other.reach);
    }
    const double touch = same ? 0.0 : this->Touch;
    if (!parts.empty())
    {
      const Point2& right = other.rightWay;
      parts = intersection(
        parts, track.where(Point2(-right.y(), right.x()), touch - cross(right, other.right)));
    }
    if (!parts.empty())
    {
      const Point2& left = other.leftWay;
      parts = intersection(
        parts, track.where(Point2(left.y(), -left.x()), touch - cross(other.left, left)));
    }
    return parts;
  }

  OffsetLine drawn(const OffsetTrack& track, const SegmentPart& part) const
  {
    std::vector<Point2> places{ track.at(part.from) };
    if (track.isArc())
    {
      double count = std::max(1.0, std::ceil((part.to - part.from) / widestArc - equalArcs));
      for (int k = 0; k < halvings && !this->tangentsMeetInside(track, part, count); ++k)
      {
        count *= 2.0;
      }
      const double step = (part.to - part.from) / count;
      for (double k = 0.0; k < count; k += 1.0)
      {
        places.push_back(track.tangentsMeet(part.from + k * step, part.from + (k + 1.0) * step));
      }
    }
    places.push_back(track.at(part.to));
    OffsetLine line;
    line.triangle = this->Windows[this->Here.front()].triangle;
    for (const Point2& place : places)
    {
      line.points.push_back(this->Flat.pointAt(this->Mesh, place, atSide));
    }
    return line;
  }

  bool tangentsMeetInside(const OffsetTrack& track, const SegmentPart& part, double count) const
  {
    const double step = (part.to - part.from) / count;
    for (double k = 0.0; k < count; k += 1.0)
    {
      const Point2 place = track.tangentsMeet(part.from + k * step, part.from + (k + 1.0) * step);
      for (Index side = 0; side < 3; ++side)
      {
        const Point2& corner = this->Flat.corner(side);
        const Point2 along = this->Flat.corner(side + 1) - corner;
        if (cross(along, place - corner) < -besideTriangle * along.squaredNorm())
        {
          return false;
        }
      }
    }
    return true;
  }

  const TriangleMesh& Mesh;
  const std::vector<OffsetWindow>& Windows;
  const std::vector<std::size_t>& Here;
  double Distance;
  double Touch;
  FlatTriangle Flat;
};

/// Which line goes on where each one ends.
std::vector<std::size_t> successors(const std::vector<OffsetLine>& lines, double distance)
{
  double greatest = 0.0;
  std::vector<std::pair<double, std::size_t>> starts;
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    starts.emplace_back(lines[k].points.front().position.x(), k);
    greatest = std::max(greatest, lines[k].points.front().position.cwiseAbs().maxCoeff());
  }
  std::sort(starts.begin(), starts.end());
  const double reach = sameEnd * distance + ofCoordinates * greatest;
  // The nearest first, so that none takes what belongs to another.
  std::vector<std::tuple<double, std::size_t, std::size_t>> gaps;
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const Point3& end = lines[k].points.back().position;
    for (auto start = std::lower_bound(
           starts.begin(), starts.end(), std::make_pair(end.x() - reach, std::size_t{ 0 }));
         start != starts.end() && start->first <= end.x() + reach; ++start)
    {
      const double gap = (lines[start->second].points.front().position - end).norm();
      if (gap <= reach && start->second != k)
      {
        gaps.emplace_back(gap, k, start->second);
      }
    }
  }
  std::sort(gaps.begin(), gaps.end());
  std::vector<std::size_t> next(lines.size(), lines.size());
  std::vector<char> follows(lines.size(), 0);
  for (const auto& [gap, before, after] : gaps)
  {
    if (next[before] == lines.size() && !follows[after])
    {
      next[before] = after;
      follows[after] = 1;
    }
  }
  return next;
}

/// Leads a path on to where the next line starts: both are one point, but for rounding, found in
/// two triangles. \param triangle of the line
void leadTo(const PathGraph& graph, Index triangle, SurfacePoint& start, SurfacePath& path)
{
  const TriangleMesh& mesh = graph.mesh();
  if (contains(mesh, triangle, path.points.back()))
  {
    start = path.points.back();
  }
  else if (contains(mesh, path.triangles.back(), start))
  {
    path.points.back() = start;
  }
  else
  {
    const StraightPath step = localStraightPath(graph, path.points.back(), start);
    if (!step.status.refused())
    {
      append(path, step.path);
    }
  }
}

void addLine(const PathGraph& graph, OffsetLine line, SurfacePath& path)
{
  if (path.points.empty())
  {
    path.points = { line.points.front() };
  }
  else
  {
    leadTo(graph, line.triangle, line.points.front(), path);
  }
  path.points.insert(path.points.end(), line.points.begin() + 1, line.points.end());
  path.triangles.insert(path.triangles.end(), line.points.size() - 1, line.triangle);
}
}

std::vector<OffsetLine> offsetLines(
  const TriangleMesh& mesh, const std::vector<OffsetWindow>& windows, double distance)
{
  std::unordered_map<Index, std::vector<std::size_t>> here;
  for (std::size_t k = 0; k < windows.size(); ++k)
  {
    here[windows[k].triangle].push_back(k);
  }
  std::vector<OffsetLine> lines;
  for (std::size_t k = 0; k < windows.size(); ++k)
  {
    if (windows[k].own)
    {
      const std::vector<std::size_t>& others = here[windows[k].triangle];
      TriangleLines(mesh, windows, others, distance).add(k, lines);
    }
  }
  return lines;
}

std::vector<SurfacePath> joined(
  const PathGraph& graph, const std::vector<OffsetLine>& lines, double distance)
{
  const std::vector<std::size_t> next = successors(lines, distance);
  std::vector<char> follows(lines.size() + 1, 0);
  for (const std::size_t after : next)
  {
    follows[after] = 1;
  }
  std::vector<SurfacePath> paths;
  std::vector<char> taken(lines.size() + 1, 0);
  taken.back() = 1;
  for (const bool closed : { false, true })
  {
    for (std::size_t first = 0; first < lines.size(); ++first)
    {
      if (taken[first] || (!closed && follows[first]))
      {
        continue;
      }
      SurfacePath path;
      for (std::size_t k = first; !taken[k]; k = next[k])
      {
        taken[k] = 1;
        addLine(graph, lines[k], path);
      }
      if (closed)
      {
        leadTo(graph, path.triangles.front(), path.points.front(), path);
      }
      if (lengthOf(path) > shortest * distance)
      {
        path.arrived = true;
        paths.push_back(std::move(path));
      }
    }
  }
  return paths;
}
}
