// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfaceTrace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

namespace flattening
{
namespace
{
/// A vertex that is no farther from the plane of a section lies in it: on which side it seems to
/// lie is rounding. A fraction of the way to the section's end.
constexpr double inPlane = 1e-12;

/// Of two ways out whose directions differ by less the first is taken, as cosines.
constexpr double equalProgress = 1e-10;

/// Walks along one plane section after the other, each from the last vertex met to the end.
///
/// Seen along the walk, vertices left of the plane have negative, those right of it positive
/// heights; zero counts as positive, so that each section crosses edges only and a walk cannot
/// branch. What is near a vertex is snapped to it afterwards.
class SectionWalk
{
public:
  SectionWalk(const TriangleMesh& mesh, const SnapDistance& snap, const SurfacePoint& end,
    const Point3& normal, double longest)
    : Mesh(mesh)
    , Snap(snap)
    , End(end)
    , Normal(normal)
    , Left(longest)
  {
  }

  SurfacePath run(const SurfacePoint& start)
  {
    this->Path.points = { start };
    while (this->advance())
    {
    }
    return std::move(this->Path);
  }

private:
  struct Exit
  {
    Index halfedge = none; ///< crossed by the section
    Index vertex = none;   ///< or gone to
  };

  double height(Index v) const { return this->Plane.dot(this->Mesh.point(v) - this->Anchor); }
  bool rightOf(Index v) const { return this->height(v) >= -this->Rounding; }
  /// Whether the section goes through a vertex.
  bool isMet(Index v) const
  {
    return std::abs(this->height(v)) <= std::max(this->Snap.ofVertex(v), this->Rounding);
  }
  bool crossesForward(Index h) const
  {
    return this->rightOf(this->Mesh.from(h)) && !this->rightOf(this->Mesh.to(h));
  }

  Point3 crossing(Index h) const
  {
    const double s = this->fraction(h);
    return (1.0 - s) * this->Mesh.point(this->Mesh.from(h)) +
      s * this->Mesh.point(this->Mesh.to(h));
  }

  double fraction(Index h) const
  {
    const double from = this->height(this->Mesh.from(h));
    const double to = this->height(this->Mesh.to(h));
    return std::clamp(from / (from - to), 0.0, 1.0);
  }

  void push(const SurfacePoint& point, Index triangle)
  {
    this->Left -= (point.position - this->Path.points.back().position).norm();
    this->Path.points.push_back(point);
    this->Path.triangles.push_back(triangle);
  }

  bool finish(Index triangle)
  {
    this->push(this->End, triangle);
    this->Path.arrived = this->Left >= 0.0;
    return false;
  }

  /// The vertex of the edge that the section passes within the snap distance, if any; none that
  /// lies behind, so that the path never turns back.
  Index vertexNear(Index h) const
  {
    const Point3& last = this->Path.points.back().position;
    const Point3 cross = this->crossing(h);
    Index near = none;
    double least = std::numeric_limits<double>::infinity();
    for (Index v : { this->Mesh.from(h), this->Mesh.to(h) })
    {
      const Point3& point = this->Mesh.point(v);
      const double distance = (point - cross).norm();
      if (this->isMet(v) && distance < least && (point - last).dot(cross - last) > 0.0)
      {
        near = v;
        least = distance;
      }
    }
    return near;
  }

  /// One section, up to the end or to a vertex; false where the walk is over.
  bool advance()
  {
    const SurfacePoint here = this->Path.points.back();
    const Index shared = commonTriangle(this->Mesh, here, this->End);
    if (shared != none)
    {
      return this->finish(shared);
    }
    const Point3 plane = (this->End.position - here.position).cross(this->Normal);
    const double size = plane.norm();
    if (!(size > 1e-6 * (this->End.position - here.position).norm()))
    {
      return false;
    }
    this->Plane = plane / size;
    this->Anchor = here.position;
    this->Rounding = inPlane * (this->End.position - here.position).norm();

    Index triangle = none;
    Exit exit = this->leave(here, triangle);
    const Index first = exit.halfedge;
    for (Index steps = 0; steps <= this->Mesh.halfedgeCount(); ++steps)
    {
      const Index h = exit.halfedge;
      if (steps > 0 && h == first)
      {
        return false; // once around, past the end
      }
      const Index vertex = h == none ? exit.vertex : this->vertexNear(h);
      if (vertex != none)
      {
        this->push(vertexPoint(this->Mesh, vertex), triangle);
        return this->Visited.insert(vertex).second;
      }
      if (h == none)
      {
        this->Path.atBoundary = onBoundary(this->Mesh, here);
        return false;
      }
      this->push(edgePoint(this->Mesh, h, this->fraction(h)), triangle);
      const Index entry = this->Mesh.twin(h);
      if (entry == none || this->Left < 0.0)
      {
        this->Path.atBoundary = entry == none;
        return false;
      }
      triangle = entry / 3;
      if (contains(this->Mesh, triangle, this->End))
      {
        return this->finish(triangle);
      }
      const Index next = TriangleMesh::next(entry);
      exit.halfedge = this->crossesForward(next) ? next : TriangleMesh::next(next);
    }
    return false;
  }

  /// How the section leaves the triangles around a point, most nearly in the walk's direction.
  Exit leave(const SurfacePoint& here, Index& triangle) const
  {
    const Point3 forward = normalAt(this->Mesh, here).cross(this->Plane);
    auto progress = [&forward, &here](const Point3& to) {
      const Point3 way = to - here.position;
      const double length = way.norm();
      return length > 0.0 ? forward.dot(way) / length : -2.0;
    };
    Exit best;
    double most = -2.0;
    const Indices around = trianglesAround(this->Mesh, here);
    for (Index t : around)
    {
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        if (this->crossesForward(h) && !edgeHolds(this->Mesh, h, here) &&
          progress(this->crossing(h)) > most + equalProgress)
        {
          most = progress(this->crossing(h));
          best.halfedge = h;
          triangle = t;
        }
      }
    }
    if (best.halfedge != none)
    {
      return best;
    }
    // On the boundary, rounding can put the section outside of the surface all along an edge.
    most = 0.0;
    for (Index t : around)
    {
      for (Index v : this->Mesh.triangle(t))
      {
        const Point3& point = this->Mesh.point(v);
        if (this->isMet(v) && progress(point) > most)
        {
          most = progress(point);
          best.vertex = v;
          triangle = t;
        }
      }
    }
    return best;
  }

  const TriangleMesh& Mesh;
  const SnapDistance& Snap;
  const SurfacePoint& End;
  Point3 Normal;
  Point3 Plane = Point3::Zero();
  Point3 Anchor = Point3::Zero();
  double Rounding = 0.0;
  double Left; ///< of the length that it may have
  std::unordered_set<Index> Visited;
  SurfacePath Path;
};
}

double lengthOf(const SurfacePath& path)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
  {
    length += (path.points[i].position - path.points[i - 1].position).norm();
  }
  return length;
}

SurfacePath traceSegment(const TriangleMesh& mesh, const SnapDistance& snap,
  const SurfacePoint& start, const SurfacePoint& end, double longest)
{
  const Point3 atStart = normalAt(mesh, start);
  const Point3 atEnd = normalAt(mesh, end);
  const Point3 along = end.position - start.position;
  const Point3 sideways = along.norm() > 0.0 ? along.unitOrthogonal() : atStart;
  SurfacePath first;
  for (const Point3& normal : { Point3(atStart + atEnd), atStart, atEnd, sideways })
  {
    const double size = normal.norm();
    if (!(size > 1e-6))
    {
      continue;
    }
    SurfacePath path = SectionWalk(mesh, snap, end, normal / size, longest).run(start);
    // Where one is too long, which of the others is not would depend on the direction.
    if (path.arrived || lengthOf(path) > longest)
    {
      return path;
    }
    if (first.points.empty())
    {
      first = std::move(path);
    }
  }
  if (first.points.empty())
  {
    first.points = { start };
  }
  return first;
}
}
