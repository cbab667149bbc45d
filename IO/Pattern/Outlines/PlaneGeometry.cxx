// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <limits>

namespace flattening::pattern
{
void addSegments(const Points2& points, bool closed, Segments& segments)
{
  const std::size_t count = points.size();
  for (std::size_t k = 0; k + (closed ? 0 : 1) < count; ++k)
  {
    segments.push_back({ points[k], points[(k + 1) % count] });
  }
}

Box boxOf(const Points2& points)
{
  Box box;
  for (const Point2& p : points)
  {
    box.extend(p);
  }
  return box;
}

std::vector<double> crossings(const Point2& from, const Point2& direction, const Segments& segments)
{
  std::vector<double> found;
  for (const Segment& segment : segments)
  {
    // By the sides of the ends, so that a border is never missed where two segments meet.
    const Point2 start = segment.from - from;
    const Point2 end = segment.to - from;
    const double left = cross(direction, start);
    const double right = cross(direction, end);
    if ((left < 0.0) != (right < 0.0))
    {
      const Point2 place = start + left / (left - right) * (end - start);
      found.push_back(place.dot(direction) / direction.squaredNorm());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

Point2 nearestPoint(const Point2& point, const Segments& segments)
{
  double least = std::numeric_limits<double>::infinity();
  Point2 nearest = point;
  for (const Segment& segment : segments)
  {
    const double at = fractionAlong(segment.from, segment.to, point);
    const Point2 place = segment.from + at * (segment.to - segment.from);
    const double squared = (place - point).squaredNorm();
    if (squared < least)
    {
      least = squared;
      nearest = place;
    }
  }
  return nearest;
}

double distance(const Point2& point, const Segments& segments)
{
  return segments.empty() ? 1e150 : (nearestPoint(point, segments) - point).norm();
}

bool enters(const Point2& from, const Point2& to, const Point2& low, const Point2& high)
{
  double first = 0.0;
  double last = 1.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double way = to[axis] - from[axis];
    if (way == 0.0)
    {
      if (from[axis] < low[axis] || from[axis] > high[axis])
      {
        return false;
      }
      continue;
    }
    const double a = (low[axis] - from[axis]) / way;
    const double b = (high[axis] - from[axis]) / way;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last;
}

bool inside(const Point2& point, const Segments& borders)
{
  bool within = false;
  for (const Segment& side : borders)
  {
    if ((side.from.y() > point.y()) != (side.to.y() > point.y()))
    {
      const double x = side.from.x() +
        (point.y() - side.from.y()) / (side.to.y() - side.from.y()) * (side.to.x() - side.from.x());
      within = within != (point.x() < x);
    }
  }
  return within;
}

Point2 widestPlace(const Segments& borders, const Segments& obstacles, double& clearance)
{
  clearance = 0.0;
  if (borders.empty())
  {
    return Point2::Zero();
  }
  Box box;
  for (const Segment& side : borders)
  {
    box.extend(side.from);
    box.extend(side.to);
  }
  Point2 best = box.min();
  Point2 center = box.center();
  Point2 half = box.sizes() / 2.0;
  // A grid, and finer ones around the best place found.
  constexpr int steps = 24;
  for (int level = 0; level < 4; ++level)
  {
    for (int i = 0; i <= steps; ++i)
    {
      for (int j = 0; j <= steps; ++j)
      {
        const Point2 place =
          center + Point2((2.0 * i / steps - 1.0) * half.x(), (2.0 * j / steps - 1.0) * half.y());
        if (!inside(place, borders))
        {
          continue;
        }
        const double room = std::min(distance(place, borders), distance(place, obstacles));
        if (room > clearance)
        {
          clearance = room;
          best = place;
        }
      }
    }
    center = best;
    half *= 2.0 / steps;
  }
  return best;
}

namespace
{
void keepFarthest(
  const Points2& polygon, std::size_t first, std::size_t last, double most, std::vector<bool>& kept)
{
  const Point2& from = polygon[first];
  const Point2& to = polygon[last % polygon.size()];
  std::size_t farthest = first;
  double distance = most;
  for (std::size_t k = first + 1; k < last; ++k)
  {
    const double off = pattern::distance(polygon[k], { { from, to } });
    if (off > distance)
    {
      farthest = k;
      distance = off;
    }
  }
  if (farthest > first)
  {
    kept[farthest] = true;
    keepFarthest(polygon, first, farthest, most, kept);
    keepFarthest(polygon, farthest, last, most, kept);
  }
}
}

Points2 thinned(const Points2& polygon, double distance)
{
  if (polygon.size() < 4)
  {
    return polygon;
  }
  const auto isNearer = [&polygon](const Point2& a, const Point2& b) {
    return (a - polygon[0]).squaredNorm() < (b - polygon[0]).squaredNorm();
  };
  const auto opposite = static_cast<std::size_t>(
    std::max_element(polygon.begin(), polygon.end(), isNearer) - polygon.begin());
  std::vector<bool> kept(polygon.size(), false);
  kept[0] = kept[opposite] = true;
  keepFarthest(polygon, 0, opposite, distance, kept);
  keepFarthest(polygon, opposite, polygon.size(), distance, kept);
  Points2 result;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    if (kept[k])
    {
      result.push_back(polygon[k]);
    }
  }
  return result;
}

Points2 simplified(const Points2& polygon, double distance)
{
  const std::size_t count = polygon.size();
  const auto skips = [&](std::size_t first, std::size_t last) {
    const Segments chord{ { polygon[first], polygon[last % count] } };
    return std::none_of(polygon.begin() + static_cast<std::ptrdiff_t>(first) + 1,
      polygon.begin() + static_cast<std::ptrdiff_t>(last),
      [&](const Point2& p) { return pattern::distance(p, chord) > distance; });
  };
  Points2 result;
  for (std::size_t k = 0; k < count;)
  {
    result.push_back(polygon[k]);
    std::size_t next = k + 1;
    while (next < count && skips(k, next + 1))
    {
      ++next;
    }
    k = next;
  }
  return result.size() < 3 ? polygon : result;
}
}
