// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PlaneSection.h"

#include "Base/Memory.h"
#include "Paths/PathPoints.h"

#include <cmath>

namespace flattening
{
namespace
{
/// How near to the end of an edge a crossing is taken for the vertex, as a fraction of the edge.
constexpr double atSectionVertex = 1e-13;

/// Where a section crosses an edge, by the heights of its ends above the plane.
SurfacePoint crossingOf(const TriangleMesh& mesh, Index edge, double from, double to)
{
  const double s = from / (from - to);
  return s < atSectionVertex    ? vertexPoint(mesh, mesh.from(edge))
    : s > 1.0 - atSectionVertex ? vertexPoint(mesh, mesh.to(edge))
                                : edgePoint(mesh, edge, s);
}

/// Follows a section from triangle to triangle. Vertices in the plane count as in front of it, so
/// that the section crosses edges only and cannot branch.
class SectionCurve
{
public:
  SectionCurve(const TriangleMesh& mesh, const SurfacePoint& start, const Point3& normal)
    : Mesh(mesh)
    , Start(start)
    , Normal(normal)
  {
  }

  PlaneSection run()
  {
    PlaneSection section;
    SurfacePath ahead = this->walk(false, section.closed);
    SurfacePath whole = std::move(ahead);
    if (!section.closed)
    {
      bool unused = false;
      SurfacePath back = reversed(this->walk(true, unused));
      append(back, whole);
      whole = std::move(back);
    }
    section.path = std::move(whole);
    section.path.arrived = true;
    section.length = lengthOf(section.path);
    if (section.path.triangles.empty())
    {
      section.status = { StatusCode::CurveLeavesSurface,
        "a plane touches the surface where it should cross it", {}, { Remedy::RedrawCurve } };
    }
    return section;
  }

private:
  double height(Index v) const
  {
    return this->Normal.dot(this->Mesh.point(v) - this->Start.position);
  }
  /// Whether the section leaves the triangle of h over it.
  bool exits(Index h, bool backwards) const
  {
    const bool from = this->height(this->Mesh.from(h)) >= 0.0;
    const bool to = this->height(this->Mesh.to(h)) >= 0.0;
    return backwards ? !from && to : from && !to;
  }

  bool startsOn(Index h) const
  {
    return this->Start.type == SurfacePointType::Vertex
      ? this->Mesh.from(h) == this->Start.id || this->Mesh.to(h) == this->Start.id
      : this->Start.type == SurfacePointType::Edge && edgeOf(this->Mesh, h) == this->Start.id;
  }

  SurfacePoint crossing(Index h) const
  {
    const Index low = edgeOf(this->Mesh, h);
    return crossingOf(
      this->Mesh, low, this->height(this->Mesh.from(low)), this->height(this->Mesh.to(low)));
  }

  Index firstExit(bool backwards) const
  {
    for (const Index t : trianglesAround(this->Mesh, this->Start))
    {
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        if (this->exits(h, backwards) && !this->startsOn(h))
        {
          return h;
        }
      }
    }
    return none;
  }

  SurfacePath walk(bool backwards, bool& closed) const
  {
    SurfacePath path;
    path.points = { this->Start };
    const Index first = this->firstExit(backwards);
    Index h = first;
    for (Index steps = 0; h != none && steps < this->Mesh.halfedgeCount(); ++steps)
    {
      const SurfacePoint point = this->startsOn(h) ? this->Start : this->crossing(h);
      if (!samePlace(point, path.points.back()))
      {
        path.points.push_back(point);
        path.triangles.push_back(h / 3);
      }
      const Index entry = this->Mesh.twin(h);
      closed = this->startsOn(h);
      if (closed || entry == none)
      {
        break;
      }
      const Index next = TriangleMesh::next(entry);
      h = this->exits(next, backwards) ? next : TriangleMesh::next(next);
      if (h == first)
      {
        // In the first triangle again.
        path.points.push_back(this->Start);
        path.triangles.push_back(h / 3);
        closed = true;
        break;
      }
    }
    return path;
  }

  const TriangleMesh& Mesh;
  const SurfacePoint& Start;
  Point3 Normal;
};

/// All curves of a section. Each triangle that has corners in front of the plane and behind it is
/// entered over one edge and left over another, and so is of one curve.
class WholeSection
{
public:
  WholeSection(const TriangleMesh& mesh, const Point3& point, const Point3& normal)
    : Mesh(mesh)
    , Visited(mesh.triangleCount(), 0)
  {
    for (const Point3& vertex : mesh.points())
    {
      this->Heights.push_back(normal.dot(vertex - point));
    }
  }

  std::vector<PlaneSection> run()
  {
    std::vector<PlaneSection> sections;
    for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
    {
      if (!this->Visited[t] && this->entering(t) != none)
      {
        PlaneSection section = this->through(t);
        // One of a single point only touches.
        if (!section.path.triangles.empty())
        {
          sections.push_back(std::move(section));
        }
      }
    }
    return sections;
  }

private:
  bool inFront(Index v) const { return this->Heights[v] >= 0.0; }
  /// The half-edge of a triangle that leads from behind the plane to its front, or back.
  Index crossed(Index t, bool back) const
  {
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      if (this->inFront(this->Mesh.from(h)) == back && this->inFront(this->Mesh.to(h)) != back)
      {
        return h;
      }
    }
    return none;
  }
  Index entering(Index t) const { return this->crossed(t, false); }
  Index leaving(Index t) const { return this->crossed(t, true); }
  Index beyond(Index h) const { return this->Mesh.twin(h) == none ? none : this->Mesh.twin(h) / 3; }

  SurfacePoint crossing(Index h) const
  {
    const Index low = edgeOf(this->Mesh, h);
    return crossingOf(
      this->Mesh, low, this->Heights[this->Mesh.from(low)], this->Heights[this->Mesh.to(low)]);
  }

  /// The curve through a triangle: from there round to it again, or from where the boundary is met.
  PlaneSection through(Index t)
  {
    Index first = t;
    Index before = this->beyond(this->entering(t));
    for (; before != none && before != t; before = this->beyond(this->entering(before)))
    {
      first = before;
    }
    PlaneSection section;
    section.closed = before == t;
    first = section.closed ? t : first;
    SurfacePath& path = section.path;
    path.points = { this->crossing(this->entering(first)) };
    for (Index at = first; at != none && !this->Visited[at]; at = this->beyond(this->leaving(at)))
    {
      this->Visited[at] = 1;
      const SurfacePoint point = this->crossing(this->leaving(at));
      if (!samePlace(point, path.points.back()))
      {
        path.points.push_back(point);
        path.triangles.push_back(at);
      }
    }
    path.arrived = true;
    section.length = lengthOf(path);
    return section;
  }

  const TriangleMesh& Mesh;
  std::vector<double> Heights;
  std::vector<char> Visited;
};
}

PlaneSection planeSection(const TriangleMesh& mesh, const SurfacePoint& point, const Point3& normal)
{
  return withinMemory([&] {
    PlaneSection section;
    const double size = normal.norm();
    if (mesh.triangleCount() == 0)
    {
      section.status = { StatusCode::EmptySurface, "there is no triangle to draw on", {},
        { Remedy::GiveTriangles } };
    }
    else if (!liesOn(mesh, point))
    {
      section.status = { StatusCode::InvalidPointId,
        "a section starts in " + std::to_string(point.id) +
          ", which is no vertex, edge or triangle of the surface" };
    }
    else if (!(size > 0.0) || !std::isfinite(size))
    {
      section.status = { StatusCode::InvalidOption, "the normal of a section has no direction", {},
        { { Remedy::Give, "a normal that is not zero" } } };
    }
    else
    {
      section = SectionCurve(mesh, point, normal / size).run();
    }
    return section;
  });
}

std::vector<PlaneSection> planeSections(
  const TriangleMesh& mesh, const Point3& point, const Point3& normal)
{
  return WholeSection(mesh, point, normal.normalized()).run();
}
}
