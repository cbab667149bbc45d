// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/StraightPath.h"

#include "Base/Memory.h"
#include "Paths/GeodesicStraightening.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Of two ways that are equally long but for rounding, that of the search is taken in every unit.
constexpr double surelyShorter = 1.0 - 1e-10;
/// The path is relaxed in 2, 4 and 8 parts while each has this many points.
constexpr std::size_t fewestPoints = 8;
constexpr int maxRelaxations = 6;
/// Rounds that gain less are not worth their time.
constexpr double minShortening = 1e-6;

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

StraightPath drawnTight(const TriangleMesh& mesh, GeodesicPath geodesic)
{
  StraightPath result;
  const Indices bent = straighten(mesh, geodesic);
  result.path = pathAlong(mesh, geodesic);
  result.length = lengthOf(result.path);
  if (!bent.empty())
  {
    result.status = { StatusCode::NotConverged, "a path is not straight at points " + listIds(bent),
      { ElementKind::Points, bent }, { Remedy::MendSlivers } };
  }
  return result;
}

/// Sections from point to point; not arrived where one of them does not, or they come to be longer
/// than the limit.
SurfacePath sectionsThrough(const TriangleMesh& mesh, const SnapDistance& snap,
  const std::vector<SurfacePoint>& points, double limit)
{
  SurfacePath path;
  double length = 0.0;
  path.points = { points.front() };
  for (const SurfacePoint& point : points)
  {
    if (!samePlace(point, path.points.back()))
    {
      const SurfacePath section =
        traceSegment(mesh, snap, path.points.back(), point, limit - length);
      if (!section.arrived)
      {
        return {};
      }
      length += lengthOf(section);
      append(path, section);
    }
  }
  path.arrived = path.points.size() > 1;
  return path;
}

/// Points of the path at equal parts of its length, or half-way between these, and its ends.
std::vector<SurfacePoint> pointsAtParts(
  const SurfacePath& path, double length, std::size_t parts, bool between)
{
  std::vector<SurfacePoint> points{ path.points.front() };
  double done = 0.0;
  double next = (between ? 0.5 : 1.0) / static_cast<double>(parts);
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i)
  {
    done += (path.points[i].position - path.points[i - 1].position).norm();
    if (done >= next * length && next <= 1.0 - 1e-9)
    {
      points.push_back(path.points[i]);
      next += 1.0 / static_cast<double>(parts);
    }
  }
  points.push_back(path.points.back());
  return points;
}

/// A shorter path between the same ends, nearly straight at large: point after point of the path is
/// joined with the next but one by a plane section of the surface (G. D. Birkhoff's curve
/// shortening). Drawing it tight takes fewer steps, each of which moves a path by one vertex.
SurfacePath relaxed(const TriangleMesh& mesh, const SnapDistance& snap, SurfacePath path)
{
  double length = lengthOf(path);
  for (const std::size_t parts : { 2, 4, 8 })
  {
    int idle = 0;
    const double before = length;
    for (int round = 0; round < maxRelaxations && idle < 2; ++round)
    {
      if (path.points.size() < parts * fewestPoints)
      {
        return path;
      }
      SurfacePath next =
        sectionsThrough(mesh, snap, pointsAtParts(path, length, parts, round % 2 == 1), length);
      const double nextLength = lengthOf(next);
      const bool gained = next.arrived && nextLength < (1.0 - minShortening) * length;
      idle = gained ? 0 : idle + 1;
      if (gained)
      {
        path = std::move(next);
        length = nextLength;
      }
    }
    if (length == before)
    {
      break;
    }
  }
  return path;
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
  const GeodesicPath way = search.geodesicTo(to);
  if (way.vertices.empty())
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
  return drawnTight(mesh, geodesicAlong(mesh, relaxed(mesh, snap, std::move(start))));
}

StraightPath byEdges(PathSearch& search, const SurfacePoint& to)
{
  const GeodesicPath way = search.geodesicTo(to);
  if (way.vertices.empty())
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
    result.status = checkPoints(mesh, { from, to }, "a path ends");
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
    return section.arrived ? drawnTight(graph.mesh(), geodesicAlong(graph.mesh(), section))
                           : straightPath(graph, from, to);
  });
}

StraightPath straightPathNear(
  const PathGraph& graph, const SurfacePath& hint, const SurfacePoint& from, const SurfacePoint& to)
{
  return withinMemory([&] {
    const TriangleMesh& mesh = graph.mesh();
    StraightPath result;
    result.status = checkPoints(mesh, { from, to }, "a path ends");
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
    return drawnTight(mesh, geodesicAlong(mesh, whole));
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

namespace
{
/// Each move shortens the band; one that goes on after these is kept from rest by rounding.
constexpr int maxMovesOfBase = 1000;
/// Halving ends before, at the rounding of a fraction.
constexpr int baseHalvings = 100;
/// A base so near to an end of its edge, as a fraction, is there.
constexpr double atEnd = 1e-9;
/// A band that is so much shorter than it was is drawn together to a point.
constexpr double vanishing = 1e-9;

class RubberBand
{
public:
  RubberBand(const TriangleMesh& mesh, SurfacePath loop)
    : Mesh(mesh)
    , Loop(std::move(loop))
    , First(lengthOf(this->Loop))
  {
  }

  StraightPath run()
  {
    StraightPath result;
    int rounds = 0;
    do
    {
      this->tighten();
    } while (!this->vanished() && this->moveBase() && ++rounds < maxMovesOfBase);
    result.path = this->Loop;
    result.length = lengthOf(result.path);
    if (this->vanished())
    {
      result.status = { StatusCode::CurveTooShort,
        "a loop can be drawn together to a point of the surface", {}, { Remedy::RedrawCurve } };
    }
    else if (rounds == maxMovesOfBase || !this->Bent.empty())
    {
      result.status = { StatusCode::NotConverged,
        "a loop is not straight at points " + listIds(this->Bent),
        { ElementKind::Points, this->Bent }, { Remedy::MendSlivers } };
    }
    return result;
  }

private:
  bool vanished() const
  {
    return this->Loop.points.size() < 3 || lengthOf(this->Loop) < vanishing * this->First;
  }

  /// Draws the band tight, held at its base.
  void tighten()
  {
    this->Geodesic = geodesicAlong(this->Mesh, this->Loop);
    this->Bent = straighten(this->Mesh, this->Geodesic);
    this->Loop = pathAlong(this->Mesh, this->Geodesic);
  }

  /// Makes another point the base where the band is not straight at this one; false where it is at
  /// rest.
  bool moveBase()
  {
    const std::size_t vertices = this->Geodesic.vertices.size();
    if (this->Loop.points.front().type == SurfacePointType::Vertex)
    {
      const GeodesicPath& c = this->Geodesic;
      const VertexSide side = sharperSide(this->Mesh, c.vertices[vertices - 2], c.segments.back(),
        c.vertices[0], c.segments.front(), c.vertices[1]);
      if (!(side.angle < pi - straightAngle))
      {
        return false;
      }
    }
    // A vertex far from the base, or else an edge to slide along.
    const std::size_t half = this->Loop.points.size() / 2;
    std::size_t base = 0;
    for (std::size_t i = 1; i + 1 < this->Loop.points.size(); ++i)
    {
      if (this->Loop.points[i].type == SurfacePointType::Vertex &&
        (base == 0 || apart(i, half) < apart(base, half)))
      {
        base = i;
      }
    }
    if (base > 0)
    {
      this->rotate(base);
      return true;
    }
    this->rotate(half);
    return this->Loop.points.front().type == SurfacePointType::Edge && this->slide();
  }

  static std::size_t apart(std::size_t a, std::size_t b) { return a < b ? b - a : a - b; }

  void rotate(std::size_t base)
  {
    SurfacePath turned = partOf(this->Loop, base, this->Loop.points.size() - 1);
    append(turned, partOf(this->Loop, 0, base));
    this->Loop = std::move(turned);
  }

  /// How fast the band gets longer as its base moves along the edge.
  double growth(const SurfacePath& loop, const Point3& along) const
  {
    const Point3& base = loop.points.front().position;
    const Point3 out = (loop.points[1].position - base).normalized();
    const Point3 in = (loop.points[loop.points.size() - 2].position - base).normalized();
    return -(out + in).dot(along);
  }

  SurfacePath heldAt(double fraction) const
  {
    SurfacePath loop = this->Loop;
    const Index edge = loop.points.front().id;
    loop.points.front() = edgePoint(this->Mesh, edge, fraction);
    loop.points.back() = loop.points.front();
    GeodesicPath geodesic = geodesicAlong(this->Mesh, loop);
    straighten(this->Mesh, geodesic);
    return pathAlong(this->Mesh, geodesic);
  }

  /// The length is a convex function of where the base is on its edge. Moves the base to its
  /// minimum; to an end of the edge where that is none inside. True where the band is to be
  /// tightened again.
  bool slide()
  {
    const Index edge = this->Loop.points.front().id;
    const Point3 along =
      (this->Mesh.point(this->Mesh.to(edge)) - this->Mesh.point(this->Mesh.from(edge)))
        .normalized();
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < baseHalvings && high - low > 1e-16 && low < 1.0 - atEnd && high > atEnd;
         ++k)
    {
      const double middle = 0.5 * (low + high);
      const SurfacePath loop = this->heldAt(middle);
      if (loop.points.size() < 3)
      {
        this->Loop = loop;
        return false;
      }
      (this->growth(loop, along) > 0.0 ? high : low) = middle;
    }
    const double best = 0.5 * (low + high);
    if (best > atEnd && best < 1.0 - atEnd)
    {
      this->Loop = this->heldAt(best);
      return false;
    }
    const SurfacePoint end =
      vertexPoint(this->Mesh, best < 0.5 ? this->Mesh.from(edge) : this->Mesh.to(edge));
    this->Loop.points.front() = end;
    this->Loop.points.back() = end;
    return true;
  }

  const TriangleMesh& Mesh;
  SurfacePath Loop;
  GeodesicPath Geodesic;
  Indices Bent;
  double First;
};
}

StraightPath straightLoop(const PathGraph& graph, const SurfacePath& loop)
{
  return withinMemory([&] {
    if (liesOn(graph.mesh(), loop) && loop.points.size() > 2 &&
      samePlace(loop.points.front(), loop.points.back()))
    {
      return RubberBand(graph.mesh(), loop).run();
    }
    StraightPath refused;
    refused.status = { StatusCode::InvalidCurve, "a loop is not a closed path over the surface", {},
      { Remedy::RedrawCurve } };
    return refused;
  });
}
}
