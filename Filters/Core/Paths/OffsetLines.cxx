// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetLines.h"

#include "Base/Types.h"
#include "Paths/PathDistance.h"
#include "Paths/PathPoints.h"
#include "Surface/SurfaceTrace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

namespace flattening
{
namespace
{
/// Tangents stand for arcs round corners and vertices. They turn by this angle at most, so that the
/// places where two meet are 1 / cos(2 degrees) = 1.0006 times as far away.
constexpr double arcStep = 4.0 * degree;
/// A fan that is narrower is one tangent: it is 1 / cos(0.25 degrees) = 1.00001 times as far away.
constexpr double narrowFan = 0.5 * degree;
constexpr double straightCorner = 1e-9; // radians that rounding makes
/// What rounding makes of distances, and of parts of sides, as a fraction of them.
constexpr double rounding = 1e-10;
/// A window is idle where another way is shorter by this fraction of the distance, which is more
/// than tangents and merged windows are nearer than arcs.
constexpr double surelySooner = 1e-3;
/// Windows side by side are one where their distances differ by less than this fraction of the side
/// that they cross, and their normals by less than this angle: over all sides that a way crosses
/// the differences sum up to this fraction of the distance.
constexpr double sameWindow = 1e-5;
constexpr double sameNormal = 0.5 * degree;
constexpr double sideBySide = 1e-6; // gap, of the side
/// Bounds memory to some 500 MB; a distance that goes round the surface many times exceeds it.
constexpr std::size_t maximumWindows = 3000000;
/// Comparisons of windows that come in by one side, some seconds; on the way over a few edges round
/// and round there are far more of them than windows.
constexpr std::size_t maximumComparisons = 30000000;

/// A triangle laid into the plane: its first corner at the origin, the second on the first axis,
/// the third above it.
class FlatTriangle
{
public:
  FlatTriangle(const TriangleMesh& mesh, Index triangle)
    : Mesh(mesh)
    , Triangle(triangle)
  {
    const Point3& origin = mesh.point(mesh.triangle(triangle)[0]);
    const Point3 side = mesh.point(mesh.triangle(triangle)[1]) - origin;
    const Point3 apex = mesh.point(mesh.triangle(triangle)[2]) - origin;
    const double length = side.norm();
    this->Along = side / length;
    this->Across = triangleNormal(mesh, triangle).cross(this->Along);
    this->Corners = { Point2(0.0, 0.0), Point2(length, 0.0),
      Point2(this->Along.dot(apex), this->Along.cross(apex).norm()) };
  }

  const Point2& corner(Index k) const { return this->Corners[k % 3]; }
  Index vertex(Index k) const { return this->Mesh.triangle(this->Triangle)[k % 3]; }
  Point2 place(const SurfacePoint& point) const
  {
    const std::array<double, 3> weights = weightsIn(this->Mesh, this->Triangle, point);
    return weights[0] * this->Corners[0] + weights[1] * this->Corners[1] +
      weights[2] * this->Corners[2];
  }
  Point2 direction(const Point3& v) const { return { this->Along.dot(v), this->Across.dot(v) }; }
  Point3 inSpace(const Point2& v) const { return v.x() * this->Along + v.y() * this->Across; }

  SurfacePoint pointAt(const Point2& place) const
  {
    std::array<double, 3> weights{};
    double sum = 0.0;
    for (Index k = 0; k < 3; ++k)
    {
      const Point2& from = this->corner(k + 1);
      weights[k] = std::max(0.0, cross(this->corner(k + 2) - from, place - from));
      sum += weights[k];
    }
    for (double& weight : weights)
    {
      weight /= sum;
    }
    return pointOf(this->Mesh, this->Triangle, weights);
  }

  /// What takes places of this triangle to those of the one beyond side k, of which it is side j.
  Eigen::Isometry2d motionTo(Index k, const FlatTriangle& beyond, Index j) const
  {
    const Point2 here = (this->corner(k) - this->corner(k + 1)).normalized();
    const Point2 there = (beyond.corner(j + 1) - beyond.corner(j)).normalized();
    const Point2 turn = Point2(here.dot(there), cross(here, there)).normalized();
    Eigen::Isometry2d motion = Eigen::Isometry2d::Identity();
    motion.linear() << turn.x(), -turn.y(), turn.y(), turn.x();
    motion.translation() = beyond.corner(j) - motion.linear() * this->corner(k + 1);
    return motion;
  }

private:
  const TriangleMesh& Mesh;
  Index Triangle;
  std::array<Point2, 3> Corners;
  Point3 Along;
  Point3 Across;
};

/// Fractions of a segment, in order.
struct SegmentPart
{
  double from = 0.0;
  double to = 1.0;
  bool empty() const { return !(this->to > this->from); }
};

/// What is left of the part where a value that changes evenly from one end of the segment to the
/// other is not negative.
SegmentPart clipped(SegmentPart part, double atStart, double atEnd)
{
  if (atStart < 0.0 && atEnd < 0.0)
  {
    return { 1.0, 0.0 };
  }
  if (atStart < 0.0)
  {
    part.from = std::max(part.from, atStart / (atStart - atEnd));
  }
  else if (atEnd < 0.0)
  {
    part.to = std::min(part.to, atStart / (atStart - atEnd));
  }
  return part;
}

/// What of a triangle a straight piece of the front goes over: between parallel rays at right
/// angles to a segment of the path, or between two rays of a fan. Places are those of the triangle
/// in the plane; apexes outside of it lie in its plane unfolded.
struct OffsetWindow
{
  Index triangle = none;
  Index entered = none; ///< the side that it comes in by; none where it starts
  bool own = false;     ///< it starts on the side of the path that the offset is on
  bool fan = false;
  bool spread = false;
  Index source = none;          ///< vertex that a fan behind it starts from
  double before = 0.0;          ///< length of the way from the path to the source
  Point2 apex = Point2::Zero(); ///< of a fan; the right end of the segment
  Point2 normal = Point2::Zero();
  // Rays that bound it, seen from the apex.
  Point2 right = Point2::Zero();
  Point2 rightWay = Point2::Zero();
  Point2 left = Point2::Zero();
  Point2 leftWay = Point2::Zero();

  double besideRight(const Point2& p) const { return cross(this->rightWay, p - this->right); }
  double besideLeft(const Point2& p) const { return cross(p - this->left, this->leftWay); }
  double away(const Point2& p) const { return this->normal.dot(p - this->apex); }
  double distance(const Point2& p) const { return this->before + this->away(p); }
  /// Which way its rays go at a place.
  Point2 way(const Point2& p) const
  {
    return this->fan ? Point2((p - this->apex).normalized()) : this->normal;
  }

  /// Its part that goes over a side, seen from the apex. Rays that meet the side, or an end of it
  /// but for rounding, stay.
  OffsetWindow through(const Point2& rightEnd, const Point2& leftEnd) const
  {
    const double touch = rounding * (leftEnd - rightEnd).norm();
    OffsetWindow window = *this;
    if (this->besideRight(rightEnd) > touch)
    {
      window.right = rightEnd;
      window.rightWay = this->way(rightEnd);
    }
    if (this->besideLeft(leftEnd) > touch)
    {
      window.left = leftEnd;
      window.leftWay = this->way(leftEnd);
    }
    return window;
  }
  /// The part of a segment that it covers.
  SegmentPart partOf(const Point2& from, const Point2& to) const
  {
    const SegmentPart part = clipped({}, this->besideRight(from), this->besideRight(to));
    return clipped(part, this->besideLeft(from), this->besideLeft(to));
  }
  OffsetWindow moved(const Eigen::Isometry2d& motion) const
  {
    OffsetWindow window = *this;
    window.apex = motion * this->apex;
    window.right = motion * this->right;
    window.left = motion * this->left;
    window.normal = motion.linear() * this->normal;
    window.rightWay = motion.linear() * this->rightWay;
    window.leftWay = motion.linear() * this->leftWay;
    return window;
  }
};

/// How far straight lines from a path go over a surface within a distance, triangle by triangle (J.
/// Chen and Y. Han, "Shortest paths on a polyhedron", 1990, without windows that S.-Q. Xin and
/// G.-J. Wang, "Improving Chen and Han's algorithm on the discrete geodesic problem", 2009, find
/// idle). Behind vertices with more than 2 pi around them, and corners of the boundary, fans go on.
/// The front is straight in each window, so that where windows end, and where one is nearer than
/// another, are segments.
class OffsetFront
{
public:
  OffsetFront(const TriangleMesh& mesh, double distance)
    : Mesh(mesh)
    , Distance(distance)
  {
  }

  /// From a path to its left, and round its start. \param own where this ends is the offset; else
  /// it is only nearer to the path
  void start(const SurfacePath& path, bool own);
  /// False where there are too many windows.
  bool run();
  /// Where own windows end, without what is nearer in any other window.
  std::vector<OffsetLine> lines() const;

private:
  void startSegment(const SurfacePath& path, std::size_t segment, bool own);
  void startFan(
    const SurfacePoint& apex, double first, double last, OffsetWindow window, double bend = 0.0);
  void push(const OffsetWindow& window, double distance);
  bool merge(OffsetWindow& window, const OffsetWindow& other) const;
  void spread(const OffsetWindow& window);
  void arrive(const OffsetWindow& window, const FlatTriangle& flat, Index corner);
  bool isIdle(const OffsetWindow& window, const FlatTriangle& flat, Index side, const Point2& right,
    const Point2& left) const;
  double reached(Index vertex) const;
  void addLines(
    std::size_t id, const std::vector<std::size_t>& here, std::vector<OffsetLine>& lines) const;

  const TriangleMesh& Mesh;
  double Distance;
  std::vector<OffsetWindow> Windows;
  std::size_t Comparisons = 0;
  std::unordered_map<Index, std::vector<std::size_t>> Waiting; ///< by the half-edge they came in by
  std::unordered_map<Index, double> Reached;                   ///< lengths of ways to vertices
  using Entry = std::pair<double, std::size_t>; ///< least distance and place of a window
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
};

void OffsetFront::start(const SurfacePath& path, bool own)
{
  const std::size_t segments = path.triangles.size();
  const bool closed = samePlace(path.points.front(), path.points.back());
  OffsetWindow onPath;
  onPath.own = own;
  for (std::size_t i = 0; i <= segments; ++i)
  {
    const SurfacePoint& point = path.points[i];
    if (point.type == SurfacePointType::Vertex)
    {
      this->Reached[point.id] = 0.0;
    }
    const PointDirections around(this->Mesh, point);
    const double all = around.total();
    const auto angleTo = [&](std::size_t segment, std::size_t end) {
      return around.angleTo(path.triangles[segment], path.points[end].position);
    };
    const std::size_t before = i > 0 ? i - 1 : segments - 1;
    double in = i > 0 || closed ? angleTo(before, before) : 0.0;
    const double out = i < segments ? angleTo(i, i + 1) : 0.0;
    if (i == 0 && !closed)
    {
      OffsetWindow atEnd;
      atEnd.own = own && around.atBoundary();
      const double last = around.atBoundary() ? all : out + all - 0.5 * pi;
      this->startFan(point, out + 0.5 * pi, last, atEnd);
    }
    else if (i == segments)
    {
      if (!closed && around.atBoundary())
      {
        this->startFan(point, 0.0, in - 0.5 * pi, onPath);
      }
      break;
    }
    // A path that turns back is gone round on both its sides, whatever rounding makes of its angle.
    else if (around.atBoundary() && in <= out + straightCorner)
    {
      this->startFan(point, 0.0, in - 0.5 * pi, onPath);
      this->startFan(point, out + 0.5 * pi, all, onPath);
    }
    else
    {
      in += in <= out + straightCorner ? all : 0.0;
      this->startFan(point, out + 0.5 * pi, in - 0.5 * pi, onPath);
    }
    this->startSegment(path, i, own);
  }
}

void OffsetFront::startSegment(const SurfacePath& path, std::size_t segment, bool own)
{
  const SurfacePoint& from = path.points[segment];
  const SurfacePoint& to = path.points[segment + 1];
  OffsetWindow window;
  window.triangle = path.triangles[segment];
  const std::array<double, 3> atFrom = weightsIn(this->Mesh, window.triangle, from);
  const std::array<double, 3> atTo = weightsIn(this->Mesh, window.triangle, to);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (atFrom[k] == 0.0 && atTo[k] == 0.0) // along the side across from corner k
    {
      const std::size_t next = (k + 1) % 3;
      Index side = 3 * window.triangle + static_cast<Index>(next);
      side = atTo[next] > atFrom[next] ? this->Mesh.twin(side) : side;
      if (side == none)
      {
        return;
      }
      window.triangle = side / 3;
      window.entered = side % 3;
      break;
    }
  }
  const FlatTriangle flat(this->Mesh, window.triangle);
  window.own = own;
  window.left = flat.place(from);
  window.right = flat.place(to);
  const Point2 along = (window.right - window.left).normalized();
  window.normal = Point2(-along.y(), along.x());
  window.rightWay = window.normal;
  window.leftWay = window.normal;
  window.apex = window.right;
  this->push(window, 0.0);
}

/// From the first angle at a point to the last, where that is greater, as tangents of an arc: the
/// first and last ones touch it at the ends. \param bend from the ends to the normals there
void OffsetFront::startFan(
  const SurfacePoint& apex, double first, double last, OffsetWindow window, double bend)
{
  const double width = last - first;
  if (!(width > straightCorner))
  {
    return;
  }
  const PointDirections around(this->Mesh, apex);
  const double count = width < narrowFan ? 0.0 : std::ceil(width / arcStep - straightCorner);
  const double step = count > 0.0 ? width / count : 2.0 * width;
  for (double k = 0.0; k <= count; k += 1.0)
  {
    const double normal = bend + (count > 0.0 ? first + k * step : first + 0.5 * width);
    const double begin = k > 0.0 ? std::clamp(normal - 0.5 * step, first, last) : first;
    const double end = k < count ? std::clamp(normal + 0.5 * step, first, last) : last;
    for (const DirectionRange& range : around.between(begin, end))
    {
      const FlatTriangle flat(this->Mesh, range.triangle);
      window.triangle = range.triangle;
      window.fan = true;
      window.apex = flat.place(apex);
      window.right = window.apex;
      window.left = window.apex;
      window.rightWay = flat.direction(range.first).normalized();
      window.leftWay = flat.direction(range.last).normalized();
      window.normal = Eigen::Rotation2Dd(normal - range.begin) * window.rightWay;
      this->push(window, window.before);
    }
  }
}

void OffsetFront::push(const OffsetWindow& window, double distance)
{
  if (window.entered != none)
  {
    std::vector<std::size_t>& waiting = this->Waiting[3 * window.triangle + window.entered];
    this->Comparisons += waiting.size();
    for (const std::size_t id : waiting)
    {
      if (!this->Windows[id].spread && this->merge(this->Windows[id], window))
      {
        this->Queue.emplace(distance, id);
        return;
      }
    }
    waiting.push_back(this->Windows.size());
  }
  this->Windows.push_back(window);
  this->Queue.emplace(distance, this->Windows.size() - 1);
}

/// Makes two windows that come in by one side into one where they are equal and side by side.
bool OffsetFront::merge(OffsetWindow& window, const OffsetWindow& other) const
{
  const FlatTriangle flat(this->Mesh, window.triangle);
  const Point2& from = flat.corner(window.entered);
  const Point2& to = flat.corner(window.entered + 1);
  // Where rays cross the line of the side, also beyond its ends: the outer ones are kept.
  const auto crossed = [&](const OffsetWindow& w) {
    const double left = w.besideLeft(from);
    const double right = w.besideRight(from);
    return SegmentPart{ left / (left - w.besideLeft(to)), right / (right - w.besideRight(to)) };
  };
  const SegmentPart one = crossed(window);
  const SegmentPart two = crossed(other);
  const auto equal = [&](double s) {
    const Point2 place = from + std::clamp(s, 0.0, 1.0) * (to - from);
    return std::abs(window.distance(place) - other.distance(place)) <=
      sameWindow * std::min((to - from).norm(), this->Distance);
  };
  if (window.own != other.own ||
    !(std::max(one.from, two.from) <= std::min(one.to, two.to) + sideBySide) ||
    !(window.normal.dot(other.normal) > std::cos(sameNormal)) ||
    !equal(std::min(one.from, two.from)) || !equal(std::max(one.to, two.to)))
  {
    return false;
  }
  OffsetWindow both = one.to - one.from >= two.to - two.from ? window : other;
  both.source = none;
  const bool firstLeft = std::abs(one.from - two.from) > sideBySide
    ? one.from < two.from
    : cross(other.leftWay, window.leftWay) > 0.0;
  const bool firstRight = std::abs(one.to - two.to) > sideBySide
    ? one.to > two.to
    : cross(other.rightWay, window.rightWay) < 0.0;
  both.left = firstLeft ? window.left : other.left;
  both.leftWay = firstLeft ? window.leftWay : other.leftWay;
  both.right = firstRight ? window.right : other.right;
  both.rightWay = firstRight ? window.rightWay : other.rightWay;
  window = both;
  return true;
}

bool OffsetFront::run()
{
  while (!this->Queue.empty() && this->Windows.size() <= maximumWindows &&
    this->Comparisons <= maximumComparisons)
  {
    OffsetWindow& next = this->Windows[this->Queue.top().second];
    this->Queue.pop();
    // Unless it has been merged, or its source been reached by a shorter way since.
    if (!next.spread && (next.source == none || !(next.before > this->Reached[next.source])))
    {
      const OffsetWindow window = next;
      next.spread = true;
      this->spread(window);
    }
  }
  return this->Queue.empty();
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
    const Point2& a = flat.corner(k);
    const Point2& b = flat.corner(k + 1);
    // Neither back nor along a side that the apex of a fan lies on.
    if (k == window.entered || twin == none ||
      !(cross(window.way(0.5 * (a + b)), b - a) > rounding * (b - a).norm()))
    {
      continue;
    }
    const SegmentPart part = clipped(window.partOf(a, b), window.away(a), window.away(b));
    if (!(part.to - part.from > rounding))
    {
      continue;
    }
    const Point2 right = a + part.from * (b - a);
    const Point2 left = a + part.to * (b - a);
    const double nearest = std::min(window.distance(right), window.distance(left));
    if (nearest < this->Distance && !this->isIdle(window, flat, k, right, left))
    {
      const FlatTriangle beyond(this->Mesh, twin / 3);
      OffsetWindow next = window.through(a, b).moved(flat.motionTo(k, beyond, twin % 3));
      next.triangle = twin / 3;
      next.entered = twin % 3;
      this->push(next, nearest);
    }
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
    return this->reached(flat.vertex(corner)) + (end - flat.corner(corner)).norm() <
      window.distance(end) - surelySooner * this->Distance;
  };
  return sooner(side, left) || sooner(side + 1, right);
}

void OffsetFront::arrive(const OffsetWindow& window, const FlatTriangle& flat, Index corner)
{
  const Point2& place = flat.corner(corner);
  const double distance = window.distance(place);
  const double margin = rounding * window.away(place);
  const Index vertex = flat.vertex(corner);
  if (!(window.besideRight(place) >= -margin) || !(window.besideLeft(place) >= -margin) ||
    !(margin > 0.0) || !(distance < this->Distance) || !(distance < this->reached(vertex)))
  {
    return;
  }
  this->Reached[vertex] = distance;
  const PointDirections around(this->Mesh, vertexPoint(this->Mesh, vertex));
  if (!around.atBoundary() && around.total() <= 2.0 * pi + straightCorner)
  {
    return; // what lies behind it is reached past it
  }
  // Where no straight line from before comes.
  const Point2 way = window.way(place);
  const double back = around.angleTo(window.triangle, this->Mesh.point(vertex) - flat.inSpace(way));
  const double bend = std::atan2(cross(way, window.normal), way.dot(window.normal));
  OffsetWindow behind;
  behind.own = window.own;
  behind.source = vertex;
  behind.before = distance;
  const SurfacePoint apex = vertexPoint(this->Mesh, vertex);
  if (around.atBoundary())
  {
    this->startFan(apex, 0.0, back - pi, behind, bend);
    this->startFan(apex, back + pi, around.total(), behind, bend);
  }
  else
  {
    this->startFan(apex, back + pi, back + around.total() - pi, behind, bend);
  }
}

std::vector<OffsetLine> OffsetFront::lines() const
{
  std::unordered_map<Index, std::vector<std::size_t>> here;
  for (std::size_t k = 0; k < this->Windows.size(); ++k)
  {
    here[this->Windows[k].triangle].push_back(k);
  }
  std::vector<OffsetLine> lines;
  for (std::size_t k = 0; k < this->Windows.size(); ++k)
  {
    if (this->Windows[k].own)
    {
      this->addLines(k, here[this->Windows[k].triangle], lines);
    }
  }
  return lines;
}

/// \param here the windows of its triangle
void OffsetFront::addLines(
  std::size_t id, const std::vector<std::size_t>& here, std::vector<OffsetLine>& lines) const
{
  const OffsetWindow& window = this->Windows[id];
  const FlatTriangle flat(this->Mesh, window.triangle);
  const double touch = rounding * this->Distance;
  const auto endOn = [&](const Point2& ray, const Point2& way) {
    return Point2(ray + (this->Distance - window.distance(ray)) / window.normal.dot(way) * way);
  };
  const Point2 a = endOn(window.left, window.leftWay);
  const Point2 b = endOn(window.right, window.rightWay);
  SegmentPart whole;
  for (Index k = 0; k < 3 && !whole.empty(); ++k)
  {
    const Point2& corner = flat.corner(k);
    const Point2 side = (flat.corner(k + 1) - corner).normalized();
    const double atA = cross(side, a - corner);
    const double atB = cross(side, b - corner);
    if (std::max(std::abs(atA), std::abs(atB)) > touch)
    {
      whole = clipped(whole, atA, atB);
    }
    // A line along a side is that of the triangle between it and the path.
    else if (window.distance(flat.corner(k + 2)) > this->Distance)
    {
      return;
    }
  }
  std::vector<SegmentPart> parts{ whole };
  for (std::size_t k = 0; k < here.size() && !parts.empty(); ++k)
  {
    // Of windows that end in the same place the first one's line is left.
    const OffsetWindow& other = this->Windows[here[k]];
    const double limit = this->Distance + (other.own && here[k] < id ? touch : -touch);
    SegmentPart gone =
      clipped(other.partOf(a, b), limit - other.distance(a), limit - other.distance(b));
    gone = clipped(gone, other.away(a), other.away(b));
    if (here[k] == id || gone.empty())
    {
      continue;
    }
    std::vector<SegmentPart> rest;
    for (const SegmentPart& part : parts)
    {
      rest.push_back({ part.from, std::min(part.to, gone.from) });
      rest.push_back({ std::max(part.from, gone.to), part.to });
    }
    rest.erase(std::remove_if(
                 rest.begin(), rest.end(), [](const SegmentPart& part) { return part.empty(); }),
      rest.end());
    parts = std::move(rest);
  }
  for (const SegmentPart& part : parts)
  {
    if ((part.to - part.from) * (b - a).norm() > touch)
    {
      lines.push_back({ window.triangle, flat.pointAt(a + part.from * (b - a)),
        flat.pointAt(a + part.to * (b - a)) });
    }
  }
}
}

std::optional<std::vector<OffsetLine>> offsetLines(
  const TriangleMesh& mesh, const SurfacePath& path, double distance)
{
  OffsetFront front(mesh, distance);
  front.start(path, true);
  front.start(reversed(path), false);
  return front.run() ? std::optional(front.lines()) : std::nullopt;
}
}
