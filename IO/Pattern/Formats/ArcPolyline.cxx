// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/ArcPolyline.h"

#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <cmath>

namespace flattening::pattern
{
namespace
{
constexpr double largestBulge = 0.7;   // 140 degrees: flat arcs are exact in every program
constexpr double smallestBulge = 1e-5; // sagitta of 5 micrometres at a chord of a meter

/// An arc between two points, through a third.
struct Arc
{
  Point2 from;
  Point2 to;
  double bulge = 0.0;
  Point2 center = Point2::Zero();
  double radius = 0.0; ///< 0: a straight line

  Arc(const Point2& first, const Point2& middle, const Point2& last)
    : from(first)
    , to(last)
  {
    const Point2 chord = last - first;
    const double length = chord.norm();
    // The angle at the middle is that of the circumference: half of the arc's complement.
    const Point2 a = first - middle;
    const Point2 b = last - middle;
    const double turn = pi - std::abs(std::atan2(cross(a, b), a.dot(b)));
    const double size = std::tan(turn / 2.0);
    const bool left = cross(chord, middle - first) < 0.0;
    if (!(length > 0.0) || !(size > smallestBulge))
    {
      return;
    }
    this->bulge = left ? size : -size;
    this->radius = length * (1.0 + size * size) / (4.0 * size);
    const Point2 normal = Point2(-chord.y(), chord.x()) / length;
    const double height = length * (1.0 - size * size) / (4.0 * size);
    this->center = (first + last) / 2.0 + (left ? height : -height) * normal;
  }

  double distance(const Point2& p) const
  {
    const Point2 chord = this->to - this->from;
    const double along = chord.dot(p - this->from) / chord.squaredNorm();
    if (!(along >= -1e-9 && along <= 1.0 + 1e-9))
    {
      return std::min((p - this->from).norm(), (p - this->to).norm());
    }
    return this->radius > 0.0 ? std::abs((p - this->center).norm() - this->radius)
                              : std::abs(cross(chord, p - this->from)) / chord.norm();
  }
};

Arc arcBetween(const Points2& line, std::size_t from, std::size_t to)
{
  const bool edge = to == from + 1;
  return { line[from], edge ? Point2((line[from] + line[to]) / 2.0) : line[(from + to) / 2],
    line[to] };
}

bool arcFits(const Points2& line, std::size_t from, std::size_t to, double tolerance)
{
  if (to == from + 1)
  {
    return true;
  }
  const Arc arc = arcBetween(line, from, to);
  if ((arc.to - arc.from).norm() < tolerance || std::abs(arc.bulge) > largestBulge)
  {
    return false;
  }
  for (std::size_t k = from; k < to; ++k)
  {
    const Point2 middle = (line[k] + line[k + 1]) / 2.0;
    if (arc.distance(line[k]) > tolerance || arc.distance(middle) > tolerance)
    {
      return false;
    }
  }
  return true;
}

/// The last point that one arc reaches: by doubling, then by halving.
std::size_t endOfArc(const Points2& line, std::size_t from, double tolerance)
{
  const std::size_t last = line.size() - 1;
  std::size_t good = from + 1;
  std::size_t bad = last + 1;
  for (std::size_t step = 2; from + step <= last; step *= 2)
  {
    if (!arcFits(line, from, from + step, tolerance))
    {
      bad = from + step;
      break;
    }
    good = from + step;
  }
  while (good + 1 < bad)
  {
    const std::size_t middle = (good + bad) / 2;
    (arcFits(line, from, middle, tolerance) ? good : bad) = middle;
  }
  return good;
}

/// The point at which a closed line turns most.
std::size_t sharpestCorner(const Points2& line)
{
  const std::size_t count = line.size();
  std::size_t sharpest = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Point2 before = line[k] - line[(k + count - 1) % count];
    const Point2 after = line[(k + 1) % count] - line[k];
    const double turn = std::abs(std::atan2(cross(before, after), before.dot(after)));
    if (turn > most)
    {
      most = turn;
      sharpest = k;
    }
  }
  return sharpest;
}
}

std::vector<ArcVertex> arcPolyline(const Points2& line, bool closed, double tolerance)
{
  Points2 points = line;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (closed && points.size() > 2)
  {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(sharpestCorner(points));
    std::rotate(points.begin(), first, points.end());
    points.push_back(points.front());
  }
  std::vector<ArcVertex> vertices;
  std::size_t from = 0;
  while (from + 1 < points.size())
  {
    const std::size_t to = endOfArc(points, from, tolerance);
    vertices.push_back({ points[from], arcBetween(points, from, to).bulge });
    from = to;
  }
  vertices.push_back({ points[from], 0.0 });
  if (closed && vertices.size() > 1)
  {
    vertices.pop_back();
  }
  return vertices;
}
}
