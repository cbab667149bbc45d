// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceArrangement.h"

#include "Base/Orientation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flattening
{
namespace
{
/// Differences below this fraction are rounding and must not decide anything.
constexpr double rounding = 1e-9;
/// A sheet wider than high reads well on a screen.
constexpr double sheetAspect = 1.6;

using Box = Eigen::AlignedBox2d;

Box boundingBox(const Points2& points)
{
  Box box;
  for (const Point2& p : points)
  {
    box.extend(p);
  }
  return box;
}

/// How far a convex hull reaches in a direction that turns anti-clockwise from one call to the
/// next: the vertex there never goes back (M. I. Shamos, "Computational Geometry", 1978).
class Farthest
{
public:
  Farthest(const Points2& points, const Indices& hull)
    : Points(points)
    , Hull(hull)
  {
  }
  double along(const Point2& origin, const Point2& direction)
  {
    const auto reach = [&](std::size_t k) {
      return (this->Points[this->Hull[k % this->Hull.size()]] - origin).dot(direction);
    };
    if (!this->Begun)
    {
      this->Begun = true;
      for (std::size_t k = 1; k < this->Hull.size(); ++k)
      {
        this->At = reach(k) > reach(this->At) ? k : this->At;
      }
    }
    for (std::size_t k = 0; k < this->Hull.size() && reach(this->At + 1) >= reach(this->At); ++k)
    {
      ++this->At;
    }
    return reach(this->At);
  }

private:
  const Points2& Points;
  const Indices& Hull;
  std::size_t At = 0;
  bool Begun = false;
};

/// Calls a function with the first vertex of each edge of the convex hull, and along the edge, as a
/// unit vector.
template <typename Visit>
void visitEdges(const Points2& points, const Indices& hull, const Visit& visit)
{
  for (std::size_t k = 0; k < hull.size(); ++k)
  {
    const Point2 along = points[hull[(k + 1) % hull.size()]] - points[hull[k]];
    const double length = along.norm();
    if (length > 0.0)
    {
      visit(hull[k], Point2(along / length));
    }
  }
}

/// Direction of the long side of the smallest rectangle around the points. One of its sides lies on
/// the convex hull; of equal ones that at the smallest vertex counts.
Point2 longDirection(const Points2& points)
{
  const Indices hull = convexHull(points);
  double smallest = std::numeric_limits<double>::max();
  Index chosen = none;
  Point2 direction(0.0, 1.0);
  Farthest ahead(points, hull);
  Farthest above(points, hull);
  Farthest behind(points, hull);
  visitEdges(points, hull, [&](Index first, const Point2& along) {
    const Point2 across(-along.y(), along.x());
    const Point2& origin = points[first];
    const Point2 sides(
      ahead.along(origin, along) + behind.along(origin, -along), above.along(origin, across));
    const double area = sides.x() * sides.y();
    const bool less = area < smallest * (1.0 - rounding);
    const bool equal = !less && area <= smallest * (1.0 + rounding);
    if (less || (equal && first < chosen))
    {
      smallest = std::min(smallest, area);
      chosen = first;
      direction = sides.x() >= sides.y() * (1.0 - rounding) ? along : across;
    }
  });
  return direction;
}

/// The piece turned so that a direction points up.
Points2 turned(const Points2& points, const Point2& up)
{
  const Point2 y = up.normalized();
  return turnedAroundFirst(points, y.y(), y.x());
}

Points2 upright(const ArrangementPiece& piece)
{
  if (piece.positions.empty())
  {
    return {};
  }
  if (piece.upright)
  {
    return turned(piece.positions, Point2::UnitY());
  }
  if (piece.grain[0] != none && piece.grain[1] != none)
  {
    const Point2 grain = piece.positions[piece.grain[1]] - piece.positions[piece.grain[0]];
    if (grain.squaredNorm() > 0.0)
    {
      return turned(piece.positions, grain);
    }
  }
  Points2 result = turned(piece.positions, longDirection(piece.positions));
  // Of the two ways up, the one with the first vertex off the middle below it.
  const Box box = boundingBox(result);
  const double middle = box.center().y();
  const double tie = 1e-6 * box.diagonal().norm();
  const auto first = std::find_if(
    result.begin(), result.end(), [&](const Point2& p) { return std::abs(p.y() - middle) > tie; });
  if (first != result.end() && first->y() > middle)
  {
    for (Point2& p : result)
    {
      p = -p;
    }
  }
  return result;
}
}

Points2 turnedAroundFirst(const Points2& points, double cosine, double sine)
{
  Points2 result;
  result.reserve(points.size());
  for (const Point2& p : points)
  {
    const Point2 d = p - points.front();
    result.emplace_back(cosine * d.x() - sine * d.y(), sine * d.x() + cosine * d.y());
  }
  return result;
}

std::vector<Point2> cornersInRows(const std::vector<Point2>& sizes, double spacing)
{
  double largest = 0.0;
  double widest = 0.0;
  for (const Point2& size : sizes)
  {
    largest = std::max(largest, size.maxCoeff());
    widest = std::max(widest, size.x());
  }
  const double gap = spacing * largest;
  double area = 0.0;
  for (const Point2& size : sizes)
  {
    area += (size.x() + gap) * (size.y() + gap);
  }
  const double width = std::max(widest, sheetAspect * std::sqrt(area)) * (1.0 + rounding);

  std::vector<Point2> corners;
  Point2 corner = Point2::Zero();
  double rowHeight = 0.0;
  for (const Point2& size : sizes)
  {
    if (corner.x() > 0.0 && corner.x() + size.x() > width)
    {
      corner = Point2(0.0, corner.y() + rowHeight + gap);
      rowHeight = 0.0;
    }
    corners.push_back(corner);
    corner.x() += size.x() + gap;
    rowHeight = std::max(rowHeight, size.y());
  }
  return corners;
}

double hullArea(const Points2& points)
{
  const Indices hull = convexHull(points);
  double twice = 0.0;
  for (std::size_t k = 2; k < hull.size(); ++k)
  {
    const Point2 a = points[hull[k - 1]] - points[hull[0]];
    const Point2 b = points[hull[k]] - points[hull[0]];
    twice += cross(a, b);
  }
  return 0.5 * twice;
}

LeastWidth leastWidth(const Points2& points)
{
  const Indices hull = convexHull(points);
  LeastWidth least;
  least.width = std::numeric_limits<double>::infinity();
  Farthest above(points, hull);
  visitEdges(points, hull, [&](Index first, const Point2& along) {
    const Point2 across(-along.y(), along.x());
    const double width = above.along(points[first], across);
    if (width < least.width * (1.0 - rounding))
    {
      least = { width, across };
    }
  });
  return least;
}

std::vector<Points2> arrangePieces(const std::vector<ArrangementPiece>& pieces, double spacing)
{
  std::vector<Points2> placed;
  std::vector<Box> boxes;
  std::vector<Point2> sizes;
  for (const ArrangementPiece& piece : pieces)
  {
    placed.push_back(upright(piece));
    boxes.push_back(boundingBox(placed.back()));
    if (!placed.back().empty())
    {
      sizes.emplace_back(boxes.back().sizes());
    }
  }
  const std::vector<Point2> corners = cornersInRows(sizes, spacing);
  auto corner = corners.begin();
  for (std::size_t i = 0; i < placed.size(); ++i)
  {
    if (placed[i].empty())
    {
      continue;
    }
    const Point2 shift = *corner++ - boxes[i].min();
    for (Point2& p : placed[i])
    {
      p += shift;
    }
  }
  return placed;
}
}
