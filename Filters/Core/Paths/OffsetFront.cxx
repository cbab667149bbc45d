// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetFront.h"

#include "Base/Types.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace flattening
{
namespace
{
constexpr double straightCorner = 1e-9; // radians
}

OffsetFamilies::OffsetFamilies(const TriangleMesh& mesh, const SurfacePath& path)
  : Mesh(mesh)
  , Path(path)
  , Closed(samePlace(path.points.front(), path.points.back()))
{
}

std::vector<OffsetFamily> OffsetFamilies::along() const
{
  std::vector<OffsetFamily> all;
  const std::size_t legs = this->Path.triangles.size();
  for (std::size_t i = 0; i < legs; ++i)
  {
    i > 0 || this->Closed ? this->addCorner(i, all) : this->addFromBoundary(i, all);
    all.push_back({ i, true });
  }
  if (!this->Closed)
  {
    this->addToBoundary(legs, all);
  }
  return all;
}

std::vector<OffsetFamily> OffsetFamilies::caps() const
{
  std::vector<OffsetFamily> caps;
  const std::size_t legs = this->Path.triangles.size();
  for (const std::size_t i : { std::size_t{ 0 }, legs })
  {
    const PointDirections around(this->Mesh, this->Path.points[i]);
    if (this->Closed || around.atBoundary())
    {
      continue;
    }
    const double leg = i == 0 ? this->outAngle(around, i) : this->inAngle(around, i);
    const double last = leg + 0.5 * pi;
    const double first = leg + around.total() - 0.5 * pi;
    if (first > last)
    {
      caps.push_back({ i, false, first, last });
    }
  }
  return caps;
}

double OffsetFamilies::outAngle(const PointDirections& around, std::size_t i) const
{
  return around.angleTo(this->Path.triangles[i], this->Path.points[i + 1].position);
}
double OffsetFamilies::inAngle(const PointDirections& around, std::size_t i) const
{
  const std::size_t before = (i == 0 ? this->Path.triangles.size() : i) - 1;
  return around.angleTo(this->Path.triangles[before], this->Path.points[before].position);
}

/// Round point i from the boundary, where it lies there, to the right angle with the leg.
void OffsetFamilies::addFromBoundary(std::size_t i, std::vector<OffsetFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double right = this->outAngle(around, i) + 0.5 * pi;
  if (around.atBoundary() && right < around.total())
  {
    all.push_back({ i, false, around.total(), right });
  }
}
/// From the right angle with the leg before point i to the boundary.
void OffsetFamilies::addToBoundary(std::size_t i, std::vector<OffsetFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double right = this->inAngle(around, i) - 0.5 * pi;
  if (around.atBoundary() && right > 0.0)
  {
    all.push_back({ i, false, right, 0.0 });
  }
}
void OffsetFamilies::addCorner(std::size_t i, std::vector<OffsetFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double out = this->outAngle(around, i);
  double in = this->inAngle(around, i);
  // A path that turns back is gone round on both its sides, whatever rounding makes of its angle.
  if (around.atBoundary() && in <= out + straightCorner)
  {
    this->addToBoundary(i, all);
    this->addFromBoundary(i, all);
    return;
  }
  in = in <= out ? in + around.total() : in;
  in = in <= out + straightCorner ? in + around.total() : in;
  if (in - out > pi + straightCorner)
  {
    all.push_back({ i, false, in - 0.5 * pi, out + 0.5 * pi });
  }
}

namespace
{
/// Angles that rounding makes, in radians.
constexpr double slack = 1e-10;
/// How far beside a window's rays a vertex may lie, as a fraction of its distance, and be met.
constexpr double beside = 1e-10;
/// A window is idle where another way is shorter by more than rounding.
constexpr double idle = 1e-9;
constexpr double onSide = 1e-12;
/// What is narrower, as a fraction of a side, goes through a corner and would circle round it.
constexpr double narrowest = 1e-13;
constexpr std::size_t mostWindows = 3000000;
constexpr double widestSector = pi / 3.0;

double distanceToSegment(const Point2& p, const Point2& a, const Point2& b)
{
  const Point2 side = b - a;
  const double square = side.squaredNorm();
  const double s = square > 0.0 ? std::clamp(side.dot(p - a) / square, 0.0, 1.0) : 0.0;
  return (a + s * side - p).norm();
}

/// The half-edge of a triangle's side on which both points lie; none where there is none.
Index sideWith(
  const TriangleMesh& mesh, Index triangle, const SurfacePoint& a, const SurfacePoint& b)
{
  const std::array<double, 3> atA = weightsIn(mesh, triangle, a);
  const std::array<double, 3> atB = weightsIn(mesh, triangle, b);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (atA[k] == 0.0 && atB[k] == 0.0)
    {
      return 3 * triangle + static_cast<Index>((k + 1) % 3);
    }
  }
  return none;
}
}

OffsetFront::OffsetFront(const TriangleMesh& mesh, double distance)
  : Mesh(mesh)
  , Distance(distance)
{
}

void OffsetFront::start(
  const SurfacePath& path, const std::vector<OffsetFamily>& families, bool own)
{
  for (const SurfacePoint& point : path.points)
  {
    if (point.type == SurfacePointType::Vertex)
    {
      this->Reached[point.id] = 0.0;
    }
  }
  for (const OffsetFamily& family : families)
  {
    if (family.leg)
    {
      this->startStrip(path, family.point, own);
    }
    else
    {
      this->startSectors(path.points[family.point], family.first, family.last, 0.0, own);
    }
  }
}

void OffsetFront::startStrip(const SurfacePath& path, std::size_t leg, bool own)
{
  const SurfacePoint& from = path.points[leg];
  const SurfacePoint& to = path.points[leg + 1];
  OffsetWindow window;
  window.triangle = path.triangles[leg];
  Index side = sideWith(this->Mesh, window.triangle, from, to);
  if (side != none)
  {
    const FlatTriangle flat(this->Mesh, window.triangle);
    const Point2 along = flat.place(this->Mesh, to) - flat.place(this->Mesh, from);
    if (along.dot(flat.corner(side % 3 + 1) - flat.corner(side % 3)) < 0.0)
    {
      side = this->Mesh.twin(side);
      if (side == none)
      {
        return;
      }
      window.triangle = side / 3;
    }
    window.entered = side % 3;
  }
  const FlatTriangle flat(this->Mesh, window.triangle);
  window.own = own;
  window.strip = true;
  window.left = flat.place(this->Mesh, from);
  window.right = flat.place(this->Mesh, to);
  const Point2 along = (window.right - window.left).normalized();
  window.normal = Point2(-along.y(), along.x());
  window.rightWay = window.normal;
  window.leftWay = window.normal;
  window.apex = window.right;
  window.reach = this->Distance;
  this->push(std::move(window), 0.0);
}

void OffsetFront::startSectors(
  const SurfacePoint& point, double last, double first, double before, bool own)
{
  const PointDirections around(this->Mesh, point);
  // A cap is three of the widest, and may not become four by rounding.
  const double count = std::ceil((last - first) / widestSector - slack);
  for (double k = 0.0; k < count; k += 1.0)
  {
    const double step = (last - first) / count;
    for (const DirectionRange& range : around.between(first + k * step, first + (k + 1.0) * step))
    {
      const FlatTriangle flat(this->Mesh, range.triangle);
      OffsetWindow window;
      window.triangle = range.triangle;
      window.own = own;
      window.apex = flat.place(this->Mesh, point);
      window.before = before;
      window.right = window.apex;
      window.left = window.apex;
      window.rightWay = flat.flat(range.first).normalized();
      window.leftWay = flat.flat(range.last).normalized();
      window.reach = this->Distance - before;
      this->push(std::move(window), before);
    }
  }
}

void OffsetFront::push(OffsetWindow window, double distance)
{
  this->Windows.push_back(std::move(window));
  this->Queue.push({ distance, this->Windows.size() - 1, true });
}

bool OffsetFront::run()
{
  while (!this->Queue.empty())
  {
    if (this->Windows.size() > mostWindows)
    {
      return false;
    }
    const Event event = this->Queue.top();
    this->Queue.pop();
    if (event.window)
    {
      this->spread(OffsetWindow(this->Windows[event.id]));
    }
    else
    {
      const Arrival arrival = this->Arrivals[event.id];
      if (!(arrival.distance > this->Reached[arrival.vertex]))
      {
        this->goOn(arrival);
      }
    }
  }
  return true;
}

/// Into the triangles around its own.
void OffsetFront::spread(const OffsetWindow& window)
{
  const FlatTriangle flat(this->Mesh, window.triangle);
  for (Index k = 0; k < 3; ++k)
  {
    // Corners on the side that it came in by have been met from the other triangle.
    if (window.entered == none || k == (window.entered + 2) % 3)
    {
      this->arrive(window, flat, k);
    }
  }
  for (Index k = 0; k < 3; ++k)
  {
    const Index twin = this->Mesh.twin(3 * window.triangle + k);
    if (k == window.entered || twin == none)
    {
      continue;
    }
    const Point2& a = flat.corner(k);
    const Point2& b = flat.corner(k + 1);
    SegmentPart part = clipped({}, window.besideRight(a), window.besideRight(b));
    part = clipped(part, window.besideLeft(a), window.besideLeft(b));
    if (window.entered == none)
    {
      // A side on which the foot lies is not left by.
      if (!window.strip &&
        std::abs(cross(b - a, window.apex - a)) <= onSide * (b - a).squaredNorm())
      {
        continue;
      }
      part = window.strip ? clipped(part, window.away(a), window.away(b)) : part;
    }
    if (!(part.to - part.from > narrowest))
    {
      continue;
    }
    const Point2 right = a + part.from * (b - a);
    const Point2 left = a + part.to * (b - a);
    const double nearest = window.strip ? std::min(window.away(right), window.away(left))
                                        : distanceToSegment(window.apex, right, left);
    if (!(nearest < window.reach) || this->isIdle(window, flat, k, right, left))
    {
      continue;
    }
    const FlatTriangle beyond(this->Mesh, twin / 3);
    OffsetWindow next = window.between(right, left).moved(flat.motionTo(k, beyond, twin % 3));
    next.triangle = twin / 3;
    next.entered = twin % 3;
    this->push(std::move(next), window.before + nearest);
  }
}

double OffsetFront::reached(Index vertex) const
{
  const auto found = this->Reached.find(vertex);
  return found == this->Reached.end() ? std::numeric_limits<double>::infinity() : found->second;
}

/// Whether all that a window reaches beyond a side is reached sooner through one of the corners.
bool OffsetFront::isIdle(const OffsetWindow& window, const FlatTriangle& flat, Index side,
  const Point2& right, const Point2& left) const
{
  const auto sooner = [&](Index corner, const Point2& end) {
    const Index vertex = this->Mesh.triangle(window.triangle)[static_cast<std::size_t>(corner % 3)];
    const double way = this->reached(vertex) + (end - flat.corner(corner)).norm();
    return way < (1.0 - idle) * (window.before + window.away(end));
  };
  return sooner(side, left) || sooner(side + 1, right);
}

void OffsetFront::arrive(const OffsetWindow& window, const FlatTriangle& flat, Index corner)
{
  const Point2& place = flat.corner(corner);
  const double away = window.away(place);
  const double distance = window.before + away;
  const double margin = beside * away;
  const Index vertex = this->Mesh.triangle(window.triangle)[static_cast<std::size_t>(corner)];
  if (!(window.besideRight(place) >= -margin) || !(window.besideLeft(place) >= -margin) ||
    !(away > 0.0) || !(away < window.reach) || !(distance < this->reached(vertex)))
  {
    return;
  }
  this->Reached[vertex] = distance;
  const PointDirections around(this->Mesh, vertexPoint(this->Mesh, vertex));
  if (!around.atBoundary() && around.total() <= 2.0 * pi + slack)
  {
    return; // what lies behind it is reached past it
  }
  const double back =
    around.angleTo(window.triangle, this->Mesh.point(vertex) + flat.spatial(window.back(place)));
  this->Arrivals.push_back({ vertex, distance, window.own, back });
  this->Queue.push({ distance, this->Arrivals.size() - 1, false });
}

/// Behind a vertex, where no straight line from before comes.
void OffsetFront::goOn(const Arrival& arrival)
{
  const SurfacePoint vertex = vertexPoint(this->Mesh, arrival.vertex);
  const PointDirections around(this->Mesh, vertex);
  const auto sectors = [&](double last, double first) {
    if (last - first > slack)
    {
      this->startSectors(vertex, last, first, arrival.distance, arrival.own);
    }
  };
  if (around.atBoundary())
  {
    sectors(arrival.angle - pi, 0.0);
    sectors(around.total(), arrival.angle + pi);
  }
  else
  {
    sectors(arrival.angle + around.total() - pi, arrival.angle + pi);
  }
}
}
