// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/CourseStraightening.h"

#include "Paths/PathPoints.h"
#include "Paths/StripUnfolding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace flattening
{
namespace
{
/// Of two sides that are equally sharp but for rounding the right one is taken.
constexpr double equalAngles = 1e-10;

double angleBetween(const Point3& a, const Point3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The half-edge of the triangle that leaves the vertex.
Index leaving(const TriangleMesh& mesh, Index triangle, Index vertex)
{
  Index h = 3 * triangle;
  while (mesh.from(h) != vertex)
  {
    ++h;
  }
  return h;
}

VertexDirection alongEdge(const TriangleMesh& mesh, Index halfedge, Index vertex)
{
  const Index twin = mesh.twin(halfedge);
  if (mesh.from(halfedge) == vertex)
  {
    return { halfedge, 0.0, true };
  }
  if (twin != none)
  {
    return { twin, 0.0, true };
  }
  // The last edge of a boundary fan has no half-edge that leaves the vertex.
  const Index last = TriangleMesh::next(halfedge);
  return { last, mesh.angle(last), false };
}
}

VertexDirection directionWithin(
  const TriangleMesh& mesh, const SurfacePoint& vertex, const SurfacePoint& other)
{
  const Index edge = commonEdge(mesh, vertex, other);
  if (edge != none)
  {
    return alongEdge(mesh, edge, vertex.id);
  }
  const Index h = leaving(mesh, commonTriangle(mesh, other, vertex), vertex.id);
  const Point3& apex = mesh.point(vertex.id);
  return { h, angleBetween(mesh.point(mesh.to(h)) - apex, other.position - apex), false };
}

VertexDirection leavingDirection(const TriangleMesh& mesh, const SurfacePoint& vertex,
  const GeodesicSegment& leg, const SurfacePoint& to)
{
  if (leg.crossed.empty())
  {
    return directionWithin(mesh, vertex, to);
  }
  return { TriangleMesh::previous(leg.crossed.front()), leg.startAngle, false };
}

VertexDirection arrivingDirection(const TriangleMesh& mesh, const SurfacePoint& from,
  const GeodesicSegment& leg, const SurfacePoint& vertex)
{
  if (leg.crossed.empty())
  {
    return directionWithin(mesh, vertex, from);
  }
  return { TriangleMesh::previous(mesh.twin(leg.crossed.back())), leg.endAngle, false };
}

KnotSide sectorBetween(
  const TriangleMesh& mesh, const VertexDirection& from, const VertexDirection& to)
{
  KnotSide side;
  if (from.halfedge == to.halfedge && from.angle <= to.angle)
  {
    side.angle = to.angle - from.angle;
    return side;
  }
  side.angle = mesh.angle(from.halfedge) - from.angle;
  for (Index h = from.halfedge;;)
  {
    const Index next = mesh.counterClockwise(h);
    if (next == none)
    {
      side.angle = std::numeric_limits<double>::infinity();
      side.crossed.clear();
      return side;
    }
    side.crossed.push_back(TriangleMesh::previous(h));
    h = next;
    if (h == to.halfedge)
    {
      break;
    }
    side.angle += mesh.angle(h);
  }
  side.angle += to.angle;
  if (to.alongEdge)
  {
    side.crossed.pop_back();
  }
  return side;
}

KnotSide sharperSide(const TriangleMesh& mesh, const SurfacePoint& before,
  const GeodesicSegment& arriving, const SurfacePoint& knot, const GeodesicSegment& leaving,
  const SurfacePoint& after)
{
  const VertexDirection in = arrivingDirection(mesh, before, arriving, knot);
  const VertexDirection out = leavingDirection(mesh, knot, leaving, after);
  KnotSide right = sectorBetween(mesh, in, out);
  KnotSide left = sectorBetween(mesh, out, in);
  if (right.angle <= left.angle + equalAngles)
  {
    return right;
  }
  left.left = true;
  std::reverse(left.crossed.begin(), left.crossed.end());
  for (Index& h : left.crossed)
  {
    h = mesh.twin(h);
  }
  return left;
}

namespace
{
/// How often a path may be led round one vertex without getting shorter by more than rounding.
constexpr int mostIdleTurns = 8;
/// A path is led round a vertex at most so often in all, and so often a vertex of the mesh. One
/// that sweeps over the whole surface once is led round each vertex once.
constexpr std::size_t fewestTurns = 1000;
constexpr std::size_t turnsPerVertex = 10;
/// What rounding may make of the length of two legs; who is shorter than that is shorter.
constexpr double leastGain = 1.0 - 1e-14;
/// How near to the end of an edge a crossing is taken for the vertex, as a fraction of the edge.
constexpr double atVertex = 1e-13;

/// Straightens in passes. Each leads every run of knots that are too sharp on one side round them
/// at once, and draws the whole strip between the knots before and after tight.
class Straightening
{
public:
  Straightening(const TriangleMesh& mesh, GeodesicPath& course, std::size_t mostTurns)
    : Mesh(mesh)
    , Course(course)
    , Left(mostTurns)
    , Fresh(course.knots.size(), 1)
  {
  }

  /// Whether it came to its end.
  bool run(std::size_t mostUnfolded)
  {
    while (this->pass())
    {
      if (this->Unfolded > mostUnfolded)
      {
        return false;
      }
    }
    return true;
  }
  Indices bent() { return std::move(this->Bent); }

private:
  /// Whether knot k has to be led round, and then its sharper side.
  bool isSharp(std::size_t k)
  {
    if (k == 0 || k + 1 >= this->Course.knots.size() || !this->Fresh[k])
    {
      return false;
    }
    const GeodesicPath& c = this->Course;
    KnotSide side =
      sharperSide(this->Mesh, c.knots[k - 1], c.legs[k - 1], c.knots[k], c.legs[k], c.knots[k + 1]);
    if (!(side.angle < pi - straightAngle))
    {
      return false;
    }
    const auto turns = this->Idle.find(c.knots[k].id);
    if (this->Left == 0 || (turns != this->Idle.end() && turns->second > mostIdleTurns))
    {
      this->Bent.push_back(c.knots[k].id);
      return false;
    }
    this->Sides.push_back(std::move(side));
    --this->Left;
    return true;
  }

  /// Whether the path goes back from knot k along the edge by which it came.
  bool turnsBack(std::size_t k) const
  {
    const GeodesicPath& c = this->Course;
    return k > 0 && k + 1 < c.knots.size() && c.legs[k - 1].crossed.empty() &&
      c.legs[k].crossed.empty() && samePlace(c.knots[k - 1], c.knots[k + 1]);
  }

  bool pass()
  {
    this->Bent.clear();
    GeodesicPath after;
    std::vector<char> fresh{ 0 };
    after.knots.push_back(this->Course.knots.front());
    bool changed = false;
    for (std::size_t k = 0; k + 1 < this->Course.knots.size();)
    {
      this->Sides.clear();
      std::size_t next = k + 1;
      // Where the path turns back along an edge it is on no side of it, and has a run of its own.
      bool back = false;
      while (!back && !(next > k + 1 && this->turnsBack(next)) && this->isSharp(next))
      {
        back = this->turnsBack(next);
        ++next;
      }
      if (next == k + 1)
      {
        after.legs.push_back(std::move(this->Course.legs[k]));
        after.knots.push_back(this->Course.knots[next]);
        fresh.push_back(this->isBent(next));
      }
      else
      {
        const GeodesicPath tight = this->ledRound(k, next);
        fresh.back() = 1;
        after.legs.insert(after.legs.end(), tight.legs.begin(), tight.legs.end());
        after.knots.insert(after.knots.end(), tight.knots.begin() + 1, tight.knots.end());
        fresh.resize(after.knots.size(), 1);
        changed = true;
      }
      k = next;
    }
    if (after.legs.empty())
    {
      after.legs.emplace_back();
      after.knots.push_back(this->Course.knots.back());
      fresh.push_back(0);
    }
    this->Course = std::move(after);
    this->Fresh = std::move(fresh);
    return changed;
  }

  bool isBent(std::size_t k) const
  {
    return std::find(this->Bent.begin(), this->Bent.end(), this->Course.knots[k].id) !=
      this->Bent.end();
  }

  /// The tight way from one knot to another on the sharper sides of those between.
  GeodesicPath ledRound(std::size_t first, std::size_t last)
  {
    const GeodesicPath& c = this->Course;
    Indices crossed;
    double length = 0.0;
    for (std::size_t k = first; k < last; ++k)
    {
      const Indices& onLeg = c.legs[k].crossed;
      length += c.legs[k].length;
      crossed.insert(crossed.end(), onLeg.begin(), onLeg.end());
      if (k + 1 == last)
      {
        break;
      }
      const KnotSide& side = this->Sides[k - first];
      crossed.insert(crossed.end(), side.crossed.begin(), side.crossed.end());
      if (k + 2 < last && c.legs[k + 1].crossed.empty() &&
        side.left != this->Sides[k - first + 1].left)
      {
        // From one side of the edge between them to the other.
        const Index a = c.knots[k + 1].id;
        const Index b = c.knots[k + 2].id;
        crossed.push_back(side.left ? this->Mesh.find(a, b) : this->Mesh.find(b, a));
      }
    }
    const SurfacePoint& start = c.knots[first];
    const SurfacePoint& end = c.knots[last];
    this->Unfolded += crossed.size();
    crossed = reducedStrip(this->Mesh, start, crossed, end);
    GeodesicPath tight;
    if (crossed.empty() && samePlace(start, end))
    {
      tight.knots = { start };
    }
    else
    {
      tight = shortestInStrip(this->Mesh, start, crossed, end);
    }
    for (const GeodesicSegment& leg : tight.legs)
    {
      length -= leg.length / leastGain;
    }
    for (std::size_t k = first + 1; k < last && !(length > 0.0); ++k)
    {
      ++this->Idle[c.knots[k].id];
    }
    return tight;
  }

  const TriangleMesh& Mesh;
  GeodesicPath& Course;
  std::size_t Left;                    ///< turns
  std::size_t Unfolded = 0;            ///< half-edges
  std::vector<char> Fresh;             ///< knots whose legs have changed since they were looked at
  std::vector<KnotSide> Sides;         ///< of a run of sharp knots
  std::unordered_map<Index, int> Idle; ///< turns that did not make the path shorter
  Indices Bent;                        ///< sharp knots that are left
};

std::size_t enoughTurns(const TriangleMesh& mesh)
{
  return fewestTurns + turnsPerVertex * static_cast<std::size_t>(mesh.vertexCount());
}

/// The half-edge of an edge that lies in the triangle.
Index halfedgeIn(const TriangleMesh& mesh, Index edge, Index triangle)
{
  return edge / 3 == triangle ? edge : mesh.twin(edge);
}

/// Appends the tight way to the next knot over the half-edges crossed since the last one.
void appendKnot(
  const TriangleMesh& mesh, const SurfacePoint& knot, Indices& crossed, GeodesicPath& course)
{
  const SurfacePoint start = course.knots.back();
  const Indices strip = reducedStrip(mesh, start, crossed, knot);
  crossed.clear();
  if (strip.empty() && samePlace(start, knot))
  {
    return;
  }
  GeodesicPath tight = shortestInStrip(mesh, start, strip, knot);
  for (std::size_t i = 0; i < tight.legs.size(); ++i)
  {
    course.legs.push_back(std::move(tight.legs[i]));
    course.knots.push_back(tight.knots[i + 1]);
  }
}
}

Indices straighten(const TriangleMesh& mesh, GeodesicPath& course)
{
  return straighten(mesh, course, enoughTurns(mesh));
}

Indices straighten(const TriangleMesh& mesh, GeodesicPath& course, std::size_t mostTurns)
{
  Straightening straightening(mesh, course, mostTurns);
  straightening.run(std::numeric_limits<std::size_t>::max());
  return straightening.bent();
}

bool straightenWithBudget(
  const TriangleMesh& mesh, GeodesicPath& course, std::size_t mostUnfolded, Indices& bent)
{
  Straightening straightening(mesh, course, enoughTurns(mesh));
  const bool ended = straightening.run(mostUnfolded);
  bent = straightening.bent();
  return ended;
}

GeodesicPath courseAlong(const TriangleMesh& mesh, const SurfacePath& path)
{
  GeodesicPath course;
  course.knots.push_back(path.points.front());
  Indices crossed;
  for (std::size_t i = 1; i < path.points.size(); ++i)
  {
    const SurfacePoint& point = path.points[i];
    if (i + 1 == path.points.size() || point.type == SurfacePointType::Vertex)
    {
      appendKnot(mesh, point, crossed, course);
    }
    else if (point.type == SurfacePointType::Edge && path.triangles[i - 1] != path.triangles[i])
    {
      crossed.push_back(halfedgeIn(mesh, point.id, path.triangles[i - 1]));
    }
  }
  if (course.legs.empty())
  {
    course.knots.push_back(path.points.back());
    course.legs.emplace_back();
  }
  return course;
}

SurfacePath pathAlong(const TriangleMesh& mesh, const GeodesicPath& course)
{
  SurfacePath path;
  path.points.push_back(course.knots.front());
  const auto push = [&path](const SurfacePoint& point, Index triangle) {
    if (!(point.type == SurfacePointType::Vertex && samePlace(point, path.points.back())))
    {
      path.points.push_back(point);
      path.triangles.push_back(triangle);
    }
  };
  for (std::size_t k = 0; k < course.legs.size(); ++k)
  {
    const Indices& crossed = course.legs[k].crossed;
    const SurfacePoint& from = course.knots[k];
    const SurfacePoint& to = course.knots[k + 1];
    const std::vector<double> fractions = crossingFractions(mesh, from, crossed, to);
    for (std::size_t i = 0; i < crossed.size(); ++i)
    {
      const Index h = crossed[i];
      const Index low = edgeOf(mesh, h);
      const double f = fractions[i];
      push(f < atVertex        ? vertexPoint(mesh, mesh.from(h))
          : f > 1.0 - atVertex ? vertexPoint(mesh, mesh.to(h))
                               : edgePoint(mesh, low, low == h ? f : 1.0 - f),
        h / 3);
    }
    push(to, crossed.empty() ? commonTriangle(mesh, from, to) : mesh.twin(crossed.back()) / 3);
  }
  if (path.triangles.empty())
  {
    path.points.push_back(course.knots.back());
    path.triangles.push_back(trianglesAround(mesh, course.knots.back()).front());
  }
  path.arrived = true;
  return path;
}
}
