// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/StraightPath.h"

#include "Base/Memory.h"
#include "Paths/CourseStraightening.h"
#include "Paths/PathRelaxation.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
bool liesOn(const TriangleMesh& mesh, const SurfacePoint& point)
{
  switch (point.carrier)
  {
    case Carrier::Vertex:
      return point.id >= 0 && point.id < mesh.vertexCount() && mesh.outgoing(point.id) != none;
    case Carrier::Edge:
      return point.id >= 0 && point.id < mesh.halfedgeCount() && edgeOf(mesh, point.id) == point.id;
    case Carrier::Face:
      break;
  }
  return point.id >= 0 && point.id < mesh.triangleCount();
}

Status checkEnds(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to)
{
  if (mesh.triangleCount() == 0)
  {
    return { StatusCode::EmptySurface, "there is no triangle to draw on", {},
      { Remedy::GiveTriangles } };
  }
  for (const SurfacePoint* point : { &from, &to })
  {
    if (!liesOn(mesh, *point))
    {
      return { StatusCode::InvalidPointId,
        "a path ends in " + std::to_string(point->id) +
          ", which is no vertex, edge or triangle of the surface" };
    }
  }
  return {};
}

/// Both ends in one triangle, where no path is shorter than the segment.
bool withinTriangle(
  const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to, StraightPath& result)
{
  const Index triangle = commonTriangle(mesh, from, to);
  if (triangle == none)
  {
    return false;
  }
  result.path = { { from, to }, { triangle }, true };
  result.length = lengthOf(result.path);
  return true;
}

StraightPath drawnTight(const TriangleMesh& mesh, PathCourse course)
{
  StraightPath result;
  const Indices bent = straighten(mesh, course);
  result.path = pathAlong(mesh, course);
  result.length = lengthOf(result.path);
  if (!bent.empty())
  {
    result.status = { StatusCode::NotConverged, "a path is not straight at points " + listIds(bent),
      { ElementKind::Points, bent }, { Remedy::MendSlivers } };
  }
  return result;
}

/// From the way of the search, or from the plane section between the ends where that is shorter.
StraightPath fromSearch(const PathSearch& search, const SurfacePoint& to)
{
  const TriangleMesh& mesh = search.graph().mesh();
  const SnapDistance& snap = search.graph().noSnap();
  const PathCourse way = search.courseTo(to);
  if (way.knots.empty())
  {
    StraightPath result;
    result.status = { StatusCode::CurveLeavesSurface,
      "no path over the surface joins two points, which lie on different parts", {},
      { Remedy::RedrawCurve } };
    return result;
  }
  SurfacePath start = pathAlong(mesh, way);
  SurfacePath section = traceSegment(mesh, snap, search.source(), to);
  if (section.arrived && lengthOf(section) < lengthOf(start))
  {
    start = std::move(section);
  }
  return drawnTight(mesh, courseAlong(mesh, relaxed(mesh, snap, std::move(start))));
}

void append(SurfacePath& path, const SurfacePath& more)
{
  path.points.insert(path.points.end(), more.points.begin() + 1, more.points.end());
  path.triangles.insert(path.triangles.end(), more.triangles.begin(), more.triangles.end());
}
}

bool liesOn(const TriangleMesh& mesh, const SurfacePath& path)
{
  if (path.points.empty() || path.points.size() != path.triangles.size() + 1 ||
    !std::all_of(path.points.begin(), path.points.end(),
      [&mesh](const SurfacePoint& point) { return liesOn(mesh, point); }))
  {
    return false;
  }
  for (std::size_t i = 0; i < path.triangles.size(); ++i)
  {
    const Index t = path.triangles[i];
    if (t < 0 || t >= mesh.triangleCount() || !contains(mesh, t, path.points[i]) ||
      !contains(mesh, t, path.points[i + 1]))
    {
      return false;
    }
  }
  return true;
}

StraightPath straightPath(const PathGraph& graph, const SurfacePoint& from, const SurfacePoint& to)
{
  return withinMemory([&] {
    StraightPath result;
    result.status = checkEnds(graph.mesh(), from, to);
    if (!result.status.ok() || withinTriangle(graph.mesh(), from, to, result))
    {
      return result;
    }
    return fromSearch(PathSearch(graph, from, to), to);
  });
}

StraightPath straightPathNear(
  const PathGraph& graph, const SurfacePath& hint, const SurfacePoint& from, const SurfacePoint& to)
{
  return withinMemory([&] {
    const TriangleMesh& mesh = graph.mesh();
    StraightPath result;
    result.status = checkEnds(mesh, from, to);
    if (!result.status.ok())
    {
      return result;
    }
    if (!liesOn(mesh, hint))
    {
      result.status = { StatusCode::InvalidCurve, "the hint of a path does not lie on the surface",
        {}, { Remedy::RedrawCurve } };
      return result;
    }
    const StraightPath toHint = straightPath(graph, from, hint.points.front());
    const StraightPath fromHint = straightPath(graph, hint.points.back(), to);
    for (const StraightPath* end : { &toHint, &fromHint })
    {
      if (end->status.refused())
      {
        return *end;
      }
    }
    SurfacePath whole = toHint.path;
    append(whole, hint);
    append(whole, fromHint.path);
    return drawnTight(mesh, courseAlong(mesh, whole));
  });
}

StraightPath straightPath(const PathSearch& search, const SurfacePoint& to)
{
  return withinMemory([&] {
    const TriangleMesh& mesh = search.graph().mesh();
    StraightPath result;
    result.status = checkEnds(mesh, search.source(), to);
    if (!result.status.ok() || withinTriangle(mesh, search.source(), to, result))
    {
      return result;
    }
    return fromSearch(search, to);
  });
}

std::vector<StraightPath> straightPaths(
  const PathSearch& search, const std::vector<SurfacePoint>& targets, const Execution& execution)
{
  std::vector<StraightPath> paths(targets.size());
  execution.parallelFor(static_cast<Index>(targets.size()), [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i)
    {
      paths[i] = straightPath(search, targets[i]);
    }
  });
  return paths;
}
}
