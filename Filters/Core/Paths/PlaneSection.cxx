// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PlaneSection.h"

#include "Base/Memory.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flattening
{
namespace
{
/// The section of a surface with the plane through a point. Vertices in the plane count as in front
/// of it, so that the section crosses edges only and cannot branch: each triangle that has corners
/// in front of the plane and behind it is entered over one edge and left over another.
class SectionWalk
{
public:
  SectionWalk(const TriangleMesh& mesh, const Point3& point, const Point3& normal)
    : Mesh(mesh)
    , Origin(point)
    , Normal(normal)
  {
  }

  /// The half-edge of a triangle that leads from the plane's front behind it, or back; none where
  /// the section does not go through the triangle.
  Index crossed(Index t, bool back) const
  {
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const bool inFront = this->height(this->Mesh.from(h)) >= 0.0;
      if (inFront != back && (this->height(this->Mesh.to(h)) >= 0.0) == back)
      {
        return h;
      }
    }
    return none;
  }

  SurfacePoint crossing(Index h) const
  {
    const Index edge = edgeOf(this->Mesh, h);
    const double from = this->height(this->Mesh.from(edge));
    const double s = from / (from - this->height(this->Mesh.to(edge)));
    return crossingPoint(this->Mesh, edge, s);
  }

  /// The curve through a point of a triangle that the section goes through.
  PlaneSection through(const SurfacePoint& start, Index triangle, std::vector<char>* visited) const
  {
    PlaneSection section;
    section.path = this->walk(start, triangle, false, section.closed, visited);
    if (!section.closed)
    {
      SurfacePath whole = reversed(this->walk(start, triangle, true, section.closed, visited));
      append(whole, section.path);
      section.path = std::move(whole);
    }
    section.path.arrived = true;
    section.length = lengthOf(section.path);
    return section;
  }

private:
  double height(Index v) const { return this->Normal.dot(this->Mesh.point(v) - this->Origin); }

  SurfacePath walk(const SurfacePoint& start, Index first, bool back, bool& closed,
    std::vector<char>* visited) const
  {
    SurfacePath path;
    path.points = { start };
    const auto push = [&path](const SurfacePoint& point, Index triangle) {
      if (!samePlace(point, path.points.back()))
      {
        path.points.push_back(point);
        path.triangles.push_back(triangle);
      }
    };
    for (Index t = first; t != none;)
    {
      const Index h = this->crossed(t, back);
      // Rounding moves no start that lies on an edge.
      const bool here = start.type == SurfacePointType::Edge && edgeOf(this->Mesh, h) == start.id;
      push(here ? start : this->crossing(h), t);
      if (visited)
      {
        (*visited)[static_cast<std::size_t>(t)] = 1;
      }
      t = this->Mesh.twin(h) == none ? none : this->Mesh.twin(h) / 3;
      if (t == first)
      {
        push(start, t);
        closed = true;
        break;
      }
    }
    return path;
  }

  const TriangleMesh& Mesh;
  Point3 Origin;
  Point3 Normal;
};
}

PlaneSection planeSection(const TriangleMesh& mesh, const SurfacePoint& point, const Point3& normal)
{
  return withinMemory([&] {
    PlaneSection section;
    section.status = checkPoints(mesh, { point }, "a section starts");
    const double size = normal.norm();
    if (!section.status.ok())
    {
      return section;
    }
    if (!(size > 0.0) || !std::isfinite(size))
    {
      section.status = { StatusCode::InvalidOption, "the normal of a section has no direction", {},
        { { Remedy::Give, "a normal that is not zero" } } };
    }
    else
    {
      const SectionWalk walk(mesh, point.position, normal / size);
      const Indices around = trianglesAround(mesh, point);
      const auto first = std::find_if(
        around.begin(), around.end(), [&walk](Index t) { return walk.crossed(t, false) != none; });
      if (first != around.end())
      {
        section = walk.through(point, *first, nullptr);
      }
      if (section.path.triangles.empty())
      {
        section.status = { StatusCode::CurveLeavesSurface,
          "a plane touches the surface where it should cross it", {}, { Remedy::RedrawCurve } };
      }
    }
    return section;
  });
}

std::vector<PlaneSection> planeSections(
  const TriangleMesh& mesh, const Point3& point, const Point3& normal)
{
  const SectionWalk walk(mesh, point, normal.normalized());
  std::vector<char> visited(static_cast<std::size_t>(mesh.triangleCount()), 0);
  std::vector<PlaneSection> sections;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Index entered = visited[static_cast<std::size_t>(t)] ? none : walk.crossed(t, true);
    if (entered != none)
    {
      PlaneSection section = walk.through(walk.crossing(entered), t, &visited);
      // One of a single point only touches.
      if (!section.path.triangles.empty())
      {
        sections.push_back(std::move(section));
      }
    }
  }
  return sections;
}

namespace
{
/// Planes through two points that are tried, and how often the best is halved between its
/// neighbours.
constexpr int planes = 36;
constexpr int planeHalvings = 40;

/// How much longer a segment gets by a point.
double detour(const SurfacePath& path, std::size_t segment, const Point3& point)
{
  const Point3& from = path.points[segment].position;
  const Point3& to = path.points[segment + 1].position;
  return (point - from).norm() + (to - point).norm() - (to - from).norm();
}

/// Where a closed section goes through a point, by triangles and not by distance alone: a surface
/// may be folded. The place in the list, which gets the point where it is not in it.
/// \param taken the places of other points
bool findStation(const TriangleMesh& mesh, SurfacePath& path, const SurfacePoint& point,
  const std::vector<std::size_t>& taken, std::size_t& station)
{
  for (std::size_t i = 0; i < path.points.size(); ++i)
  {
    if (samePlace(path.points[i], point))
    {
      station = i;
      return true;
    }
  }
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i)
  {
    // An edge may lie in the plane, and be crossed anywhere.
    if (path.points[i].type == SurfacePointType::Edge && point.type == SurfacePointType::Edge &&
      path.points[i].id == point.id && std::count(taken.begin(), taken.end(), i) == 0)
    {
      path.points[i] = point;
      station = i;
      return true;
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.triangles.size(); ++i)
  {
    if (contains(mesh, path.triangles[i], point) && detour(path, i, point.position) < least)
    {
      least = detour(path, i, point.position);
      station = i + 1;
    }
  }
  if (!std::isfinite(least))
  {
    return false;
  }
  const auto at = static_cast<std::ptrdiff_t>(station);
  path.points.insert(path.points.begin() + at, point);
  path.triangles.insert(path.triangles.begin() + at, path.triangles[station - 1]);
  return true;
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
    if (!findStation(mesh, section.path, points[k], stations, station))
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
    const double least =
      leastBetween(best - pi / planes, best + pi / planes, planeHalvings, 0.0, tape);
    const double refined = tape(least) <= shortest ? least : best;
    return closedThrough(
      mesh, points, std::cos(refined) * first + std::sin(refined) * second, where);
  });
}
}
