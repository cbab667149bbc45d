// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PlaneSection.h"

#include "Base/Memory.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// How near to the end of an edge a crossing is taken for the vertex, as a fraction of the edge.
constexpr double atVertex = 1e-13;
/// Planes through two points that are tried, and how often the best is halved between its
/// neighbours.
constexpr int planes = 36;
constexpr int halvings = 40;
constexpr double goldenRatio = 0.6180339887498949;

/// Where a section crosses an edge, by the heights of its ends above the plane.
SurfacePoint crossingOf(const TriangleMesh& mesh, Index edge, double from, double to)
{
  const double s = from / (from - to);
  return s < atVertex    ? vertexPoint(mesh, mesh.from(edge))
    : s > 1.0 - atVertex ? vertexPoint(mesh, mesh.to(edge))
                         : edgePoint(mesh, edge, s);
}

/// Follows a section from triangle to triangle. Vertices in the plane count as in front of it, so
/// that the section crosses edges only and cannot branch.
class SectionCurve
{
public:
  /// Marks the triangles that it goes through, also those of which it only meets a corner.
  SectionCurve(const TriangleMesh& mesh, const SurfacePoint& start, const Point3& normal,
    std::vector<char>* visited = nullptr)
    : Mesh(mesh)
    , Start(start)
    , Normal(normal)
    , Visited(visited)
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
    return this->Start.carrier == Carrier::Vertex
      ? this->Mesh.from(h) == this->Start.id || this->Mesh.to(h) == this->Start.id
      : this->Start.carrier == Carrier::Edge && edgeOf(this->Mesh, h) == this->Start.id;
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
      if (this->Visited)
      {
        (*this->Visited)[h / 3] = 1;
      }
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
  std::vector<char>* Visited;
};

/// Where a section goes through a point, by triangles and not by distance alone: a surface may be
/// folded. The place in the list, before which the point is to be inserted where it is not in it.
bool findStation(
  const TriangleMesh& mesh, SurfacePath& path, const SurfacePoint& point, std::size_t& station)
{
  for (std::size_t i = 0; i < path.points.size(); ++i)
  {
    if (samePlace(path.points[i], point) ||
      (path.points[i].carrier == Carrier::Edge && point.carrier == Carrier::Edge &&
        path.points[i].id == point.id))
    {
      station = i;
      return true;
    }
  }
  for (std::size_t i = 0; i < path.triangles.size(); ++i)
  {
    if (contains(mesh, path.triangles[i], point))
    {
      station = i + 1;
      path.points.insert(path.points.begin() + static_cast<std::ptrdiff_t>(station), point);
      path.triangles.insert(
        path.triangles.begin() + static_cast<std::ptrdiff_t>(i), path.triangles[i]);
      return true;
    }
  }
  return false;
}

PlaneSection notClosed()
{
  PlaneSection refused;
  refused.status = { StatusCode::CurveLeavesSurface,
    "no closed section of the surface goes through the points of a girth", {},
    { Remedy::RedrawCurve } };
  return refused;
}

PlaneSection closedThrough(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points,
  const Point3& normal, std::vector<std::size_t>& stations)
{
  PlaneSection section = planeSection(mesh, points.front(), normal);
  if (!section.status.ok() || !section.closed)
  {
    return notClosed();
  }
  stations.assign(1, 0);
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    const std::size_t before = section.path.points.size();
    std::size_t station = 0;
    if (!findStation(mesh, section.path, points[k], station))
    {
      return notClosed();
    }
    for (std::size_t& other : stations)
    {
      other += section.path.points.size() > before && other >= station ? 1 : 0;
    }
    stations.push_back(station);
  }
  if (points.size() == 3 && stations[1] > stations[2])
  {
    section.path = reversed(std::move(section.path));
    for (std::size_t k = 1; k < 3; ++k)
    {
      stations[k] = section.path.points.size() - 1 - stations[k];
    }
  }
  section.length = lengthOf(section.path);
  return section;
}
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
  const Point3 unit = normal.normalized();
  const auto height = [&](Index v) { return unit.dot(mesh.point(v) - point); };
  std::vector<char> visited(mesh.triangleCount(), 0);
  std::vector<PlaneSection> sections;
  const auto follow = [&](Index t, bool fromVertices) {
    for (Index h = 3 * t; h < 3 * t + 3 && visited[t] == 0; ++h)
    {
      const double from = height(mesh.from(h));
      const double to = height(mesh.to(h));
      const Index edge = edgeOf(mesh, h);
      if (from >= 0.0 || to < 0.0)
      {
        continue;
      }
      const SurfacePoint start =
        crossingOf(mesh, edge, edge == h ? from : to, edge == h ? to : from);
      if ((start.carrier == Carrier::Vertex) != fromVertices)
      {
        continue;
      }
      visited[t] = 1;
      PlaneSection section = SectionCurve(mesh, start, unit, &visited).run();
      for (const Index around : fromVertices ? trianglesAround(mesh, start) : Indices{})
      {
        visited[around] = 1; // The walk begins beyond them.
      }
      if (section.status.ok())
      {
        sections.push_back(std::move(section));
      }
    }
  };
  // From a vertex only where a curve goes through nothing else: several may go through one.
  for (const bool fromVertices : { false, true })
  {
    for (Index t = 0; t < mesh.triangleCount(); ++t)
    {
      follow(t, fromVertices);
    }
  }
  return sections;
}

PlaneSection girth(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points,
  std::vector<std::size_t>* stations)
{
  return withinMemory([&] {
    std::vector<std::size_t> found;
    std::vector<std::size_t>& where = stations ? *stations : found;
    if (points.size() != 2 && points.size() != 3)
    {
      PlaneSection refused;
      refused.status = { StatusCode::InvalidOption,
        "a girth goes through two or three points, not " + std::to_string(points.size()), {},
        { { Remedy::Give, "two or three points" } } };
      return refused;
    }
    const Point3 along = points[1].position - points[0].position;
    if (points.size() == 3)
    {
      return closedThrough(
        mesh, points, along.cross(points[2].position - points[0].position), where);
    }
    if (!(along.norm() > 0.0))
    {
      return notClosed();
    }
    const Point3 first = along.unitOrthogonal();
    const Point3 second = along.normalized().cross(first);
    const auto tape = [&](double angle) {
      std::vector<std::size_t> places;
      const PlaneSection section =
        closedThrough(mesh, points, std::cos(angle) * first + std::sin(angle) * second, places);
      return section.status.ok() ? section.length : std::numeric_limits<double>::infinity();
    };
    double best = 0.0;
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < planes; ++k)
    {
      const double length = tape(pi * k / planes);
      if (length < shortest)
      {
        shortest = length;
        best = pi * k / planes;
      }
    }
    double low = best - pi / planes;
    double high = best + pi / planes;
    for (int k = 0; k < halvings; ++k)
    {
      const double a = high - goldenRatio * (high - low);
      const double b = low + goldenRatio * (high - low);
      (tape(a) <= tape(b) ? high : low) = tape(a) <= tape(b) ? b : a;
    }
    const double refined = tape(0.5 * (low + high)) <= shortest ? 0.5 * (low + high) : best;
    return closedThrough(
      mesh, points, std::cos(refined) * first + std::sin(refined) * second, where);
  });
}
}
