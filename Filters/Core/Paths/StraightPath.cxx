// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/StraightPath.h"

#include "Base/Memory.h"
#include "Paths/CourseStraightening.h"
#include "Paths/PathPoints.h"
#include "Paths/PathShortening.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Of two ways that are equally long but for rounding, that of the search is taken in every unit.
constexpr double surelyShorter = 1.0 - 1e-10;
/// How many half-edges drawing a path tight may unfold, a millisecond's work, before its
/// development is tried, and how many times more where that gained no more than this fraction of
/// its length.
constexpr std::size_t fewUnfolded = 20000;
constexpr std::size_t lossOfPatience = 4;
constexpr double leastGainOfRound = 1e-4;
constexpr double manyKnots = 0.05; // for each edge crossed

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

StraightPath drawnTight(const TriangleMesh& mesh, GeodesicPath course)
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

/// Whether a course goes through so many vertices that they hold it, as on the inside of a bend.
bool isHeld(const GeodesicPath& course)
{
  std::size_t crossed = 0;
  for (const GeodesicSegment& leg : course.legs)
  {
    crossed += leg.crossed.size();
  }
  return static_cast<double>(course.knots.size()) > manyKnots * static_cast<double>(crossed);
}

/// A course that is not far from tight. Drawing tight moves a path by a row of vertices at a time;
/// one that has farther to go is moved by its development, where that helps.
GeodesicPath drawnNearlyTight(
  const TriangleMesh& mesh, const SnapDistance& snap, const SurfacePath& start)
{
  GeodesicPath course = courseAlong(mesh, start);
  std::size_t patience = fewUnfolded;
  bool first = true;
  Indices bent;
  while (!straightenWithBudget(mesh, course, patience, bent))
  {
    double gain = 0.0;
    if (first || !isHeld(course))
    {
      const SurfacePath path = pathAlong(mesh, course);
      const SurfacePath moved = developed(mesh, snap, path);
      gain = 1.0 - lengthOf(moved) / lengthOf(path);
      course = gain > 0.0 ? courseAlong(mesh, moved) : std::move(course);
    }
    patience *= gain > leastGainOfRound ? 1 : lossOfPatience;
    first = false;
  }
  return course;
}

StraightPath notJoined()
{
  StraightPath result;
  result.status = { StatusCode::CurveLeavesSurface,
    "no path over the surface joins two points, which lie on different parts", {},
    { Remedy::RedrawCurve } };
  return result;
}

/// From the way of the search, or from the plane section between the ends where that is shorter.
StraightPath fromSearch(PathSearch& search, const SurfacePoint& to)
{
  const TriangleMesh& mesh = search.graph().mesh();
  const SnapDistance& snap = search.graph().noSnap();
  const GeodesicPath way = search.courseTo(to);
  if (way.knots.empty())
  {
    return notJoined();
  }
  SurfacePath start = pathAlong(mesh, way);
  SurfacePath section =
    traceSegment(mesh, snap, search.source(), to, surelyShorter * lengthOf(start));
  if (section.arrived)
  {
    start = std::move(section);
  }
  return drawnTight(mesh, drawnNearlyTight(mesh, snap, relaxed(mesh, snap, std::move(start))));
}

StraightPath byEdges(PathSearch& search, const SurfacePoint& to)
{
  const GeodesicPath way = search.courseTo(to);
  if (way.knots.empty())
  {
    return notJoined();
  }
  StraightPath result;
  result.path = pathAlong(search.graph().mesh(), way);
  result.length = lengthOf(result.path);
  return result;
}

/// What a search gives, but for ends that are none or in one triangle, and memory that runs out.
template <typename Search>
StraightPath withEndsChecked(
  const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to, const Search& search)
{
  return withinMemory([&] {
    StraightPath result;
    result.status = checkEnds(mesh, from, to);
    return result.status.ok() && !withinTriangle(mesh, from, to, result) ? search() : result;
  });
}
}

StraightPath straightPath(const PathGraph& graph, const SurfacePoint& from, const SurfacePoint& to)
{
  return withEndsChecked(graph.mesh(), from, to, [&] {
    PathSearch search(graph, from);
    return fromSearch(search, to);
  });
}

StraightPath straightPath(PathSearch& search, const SurfacePoint& to)
{
  return withEndsChecked(
    search.graph().mesh(), search.source(), to, [&] { return fromSearch(search, to); });
}

StraightPath localStraightPath(
  const PathGraph& graph, const SurfacePoint& from, const SurfacePoint& to)
{
  return withEndsChecked(graph.mesh(), from, to, [&] {
    const SurfacePath section = traceSegment(graph.mesh(), graph.noSnap(), from, to);
    return section.arrived ? drawnTight(graph.mesh(), courseAlong(graph.mesh(), section))
                           : straightPath(graph, from, to);
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

StraightPath pathByEdges(const PathGraph& graph, const SurfacePoint& from, const SurfacePoint& to)
{
  return withEndsChecked(graph.mesh(), from, to, [&] {
    PathSearch search(graph, from, PathArcs::Edges);
    return byEdges(search, to);
  });
}

StraightPath pathByEdges(PathSearch& search, const SurfacePoint& to)
{
  return withEndsChecked(
    search.graph().mesh(), search.source(), to, [&] { return byEdges(search, to); });
}
}
