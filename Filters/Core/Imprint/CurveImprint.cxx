// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/CurveImprint.h"

#include "Base/CompressedRows.h"
#include "Base/Memory.h"
#include "Imprint/ImprintedSurface.h"
#include "Imprint/SurfaceSplit.h"
#include "Surface/SurfaceLocator.h"
#include "Surface/SurfacePoint.h"
#include "Surface/SurfaceTrace.h"
#include "Surface/TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace flattening
{
namespace
{
double diagonal(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d bounds;
  for (const Triangle& t : mesh.triangles())
  {
    for (Index v : t)
    {
      bounds.extend(mesh.point(v));
    }
  }
  return bounds.isEmpty() ? 0.0 : bounds.diagonal().norm();
}

/// Per query the nearest vertex within the radius, with all others at the same place; ascending
/// ids. One pass over the vertices against the queries sorted along a line: a few curves on a large
/// mesh cost no search structure over the mesh. Vertices that no triangle uses are left out.
/// \param same points that are nearer to each other differ by rounding alone, and are one place
std::vector<Indices> matchVertices(
  const TriangleMesh& mesh, const Points3& queries, double radius, double same)
{
  // Along a direction to which no row of a mesh is likely to be at right angles.
  const auto height = [](const Point3& p) { return p.dot(Point3(0.48, 0.6, 0.64)); };
  std::vector<std::pair<double, Index>> byHeight;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    byHeight.emplace_back(height(queries[i]), static_cast<Index>(i));
  }
  std::sort(byHeight.begin(), byHeight.end());
  const double reach = radius + same;
  std::vector<Indices> nearest(queries.size());
  std::vector<double> distance(queries.size(), std::numeric_limits<double>::infinity());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const double place = height(mesh.point(v));
    auto query =
      std::lower_bound(byHeight.begin(), byHeight.end(), std::make_pair(place - reach, Index{ 0 }));
    for (; query != byHeight.end() && query->first <= place + reach; ++query)
    {
      const Index i = query->second;
      const double d = (mesh.point(v) - queries[i]).norm();
      if (mesh.outgoing(v) == none || d > radius || d > distance[i] + same)
      {
        continue;
      }
      if (d < distance[i] - same)
      {
        nearest[i].clear();
      }
      nearest[i].push_back(v);
      distance[i] = std::min(d, distance[i]);
    }
  }
  return nearest;
}

/// One vertex per point of a polyline, none where it has no candidate. Where points of the mesh
/// coincide without being joined, as on the two sides of an open slit, the curve stays on its side:
/// as many steps as possible are edges; then the smaller ids win.
Indices chooseVertices(const TriangleMesh& mesh, const std::vector<Indices>& candidates)
{
  // Dynamic programming along the curve: per candidate the fewest steps that are no edge.
  std::vector<Indices> jumps(candidates.size());
  std::vector<Indices> before(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    jumps[i].assign(candidates[i].size(), 0);
    before[i].assign(candidates[i].size(), none);
    for (std::size_t k = 0; i > 0 && k < candidates[i].size(); ++k)
    {
      for (std::size_t j = 0; j < candidates[i - 1].size(); ++j)
      {
        const Index from = candidates[i - 1][j];
        const Index to = candidates[i][k];
        const bool joined =
          from == to || mesh.find(from, to) != none || mesh.find(to, from) != none;
        const Index count = jumps[i - 1][j] + (joined ? 0 : 1);
        if (before[i][k] == none || count < jumps[i][k])
        {
          jumps[i][k] = count;
          before[i][k] = static_cast<Index>(j);
        }
      }
    }
  }
  Indices chosen(candidates.size(), none);
  Index next = none;
  for (std::size_t i = candidates.size(); i-- > 0;)
  {
    if (candidates[i].empty())
    {
      next = none;
      continue;
    }
    const Index k = next != none
      ? next
      : static_cast<Index>(std::min_element(jumps[i].begin(), jumps[i].end()) - jumps[i].begin());
    chosen[i] = candidates[i][k];
    next = before[i][k];
  }
  return chosen;
}

/// Of the surface's diagonal: a curve that is farther off was not drawn on this surface as it is.
constexpr double nearby = 0.1;

/// The next larger number of two digits.
double roundedUp(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::ceil(value / unit * (1.0 - 1e-12)) * unit;
}

ImprintedSurface refuse(Status status)
{
  ImprintedSurface result;
  result.status = std::move(status);
  return result;
}

/// Identity: the mesh as it is.
ImprintedSurface keepMesh(const TriangleMesh& mesh)
{
  ImprintedSurface result;
  result.mesh = mesh;
  result.vertexSource.resize(mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    result.vertexSource[v].vertices = { v, v, v };
  }
  result.originalTriangle.resize(mesh.triangleCount());
  std::iota(result.originalTriangle.begin(), result.originalTriangle.end(), 0);
  return result;
}

/// Imprints a list of polylines; the first status that is not Ok ends it.
class Imprinter
{
public:
  Imprinter(const TriangleMesh& mesh, const std::vector<Polyline>& polylines,
    const ImprintOptions& options, const Execution& execution)
    : Mesh(mesh)
    , Polylines(polylines)
    , Options(options)
    , Execute(execution)
    , Diagonal(diagonal(mesh))
    , Reach(options.tolerance * this->Diagonal)
    , AtVertex(mesh, std::max(0.01, options.snap))
  {
  }

  ImprintedSurface run()
  {
    Status sound = checkPolylines(this->Polylines);
    if (!sound.ok())
    {
      return refuse(std::move(sound));
    }
    this->findVertices();
    std::vector<Route> routes(this->Polylines.size());
    std::vector<char> alongEdges(this->Polylines.size(), 0);
    bool all = true;
    for (std::size_t c = 0; c < this->Polylines.size(); ++c)
    {
      Status status = this->followEdges(c, routes[c]);
      alongEdges[c] = status.ok() ? 1 : 0;
      all = all && status.ok();
      if (!status.ok() && !this->Options.split)
      {
        status.curve = static_cast<Index>(c);
        return refuse(std::move(status));
      }
    }
    return all ? this->collect(keepMesh(this->Mesh), std::move(routes))
               : this->split(routes, alongEdges);
  }

private:
  /// Finds the vertices of all points in one pass over the mesh. \pre The points are finite.
  void findVertices()
  {
    Points3 queries;
    for (const Polyline& polyline : this->Polylines)
    {
      this->First.push_back(queries.size());
      queries.insert(queries.end(), polyline.points.begin(), polyline.points.end());
    }
    const double reach =
      this->Options.split ? std::min(this->Reach, this->AtVertex.greatest()) : this->Reach;
    std::vector<Indices> candidates =
      matchVertices(this->Mesh, queries, reach, 1e-12 * this->Diagonal);
    this->keepNearVertices(queries, candidates);
    for (std::size_t c = 0; c < this->Polylines.size(); ++c)
    {
      const auto first = candidates.begin() + static_cast<std::ptrdiff_t>(this->First[c]);
      const Indices chosen = chooseVertices(this->Mesh,
        { first, first + static_cast<std::ptrdiff_t>(this->Polylines[c].points.size()) });
      this->Vertices.insert(this->Vertices.end(), chosen.begin(), chosen.end());
    }
  }

  /// The vertex that a point of a polyline is, none where it lies elsewhere.
  Index vertex(std::size_t polyline, std::size_t point) const
  {
    return this->Vertices[this->First[polyline] + point];
  }

  /// The tolerance says how far from the surface a point may be. It must not drag points along the
  /// surface to vertices that are not meant: where triangles can be split, those that are not near;
  /// else those that are not the nearest.
  void keepNearVertices(const Points3& queries, std::vector<Indices>& candidates) const
  {
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      Indices& near = candidates[i];
      const auto distance = [&](Index vertex) {
        return (this->Mesh.point(vertex) - queries[i]).norm();
      };
      double nearest = std::numeric_limits<double>::infinity();
      for (const Index vertex : near)
      {
        nearest = std::min(nearest, distance(vertex));
      }
      eraseIf(near, [&](Index vertex) {
        return distance(vertex) > this->AtVertex.ofVertex(vertex) &&
          (this->Options.split || distance(vertex) > nearest);
      });
    }
  }

  /// The nearest point of the surface per point of polyline c. Errors: CurvePointOffSurface (ids:
  /// points of the polyline).
  Status locate(std::size_t c, std::vector<ClosestPoint>& closest)
  {
    if (!this->Locator)
    {
      this->Locator.emplace(this->Mesh);
      connectedParts(this->Mesh, {}, this->Parts);
    }
    const Polyline& polyline = this->Polylines[c];
    Indices off;
    double farthest = 0.0;
    const std::vector<SheetLocator::Place> places = this->Locator->along(polyline.points);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const ClosestPoint& point = places[i].closest;
      closest.push_back(point);
      if (point.triangle == none || point.distance > this->Reach)
      {
        off.push_back(pointId(polyline, i));
        farthest = std::max(farthest, point.distance);
      }
      Index& vertex = this->Vertices[this->First[c] + i];
      const Indices& sheet = places[i].sheet;
      const bool offSheet =
        !sheet.empty() && std::none_of(sheet.begin(), sheet.end(), [&](Index t) {
          const Triangle& corners = this->Mesh.triangle(t);
          return std::find(corners.begin(), corners.end(), vertex) != corners.end();
        });
      const bool elsewhere = offSheet ||
        (vertex != none && point.triangle != none &&
          this->Parts[this->Mesh.outgoing(vertex) / 3] != this->Parts[point.triangle]);
      vertex = elsewhere ? none : vertex;
    }
    if (off.empty())
    {
      return {};
    }
    SuggestedRemedies remedies{ Remedy::ProjectPoints };
    if (const double fraction = roundedUp(farthest / this->Diagonal); fraction <= nearby)
    {
      remedies.push_back({ Remedy::RaiseImprintTolerance, shortNumber(fraction) });
    }
    return { StatusCode::CurvePointOffSurface,
      curveName(polyline, c) + ": points " + listIds(off) + " lie up to " + shortNumber(farthest) +
        " off the surface, more than the tolerance of " + shortNumber(this->Reach) +
        ", both in the unit of the surface" +
        (farthest > nearby * this->Diagonal
            ? ", as where curve and surface differ in unit, axes or place"
            : ""),
      { ElementKind::CurvePoints, off }, std::move(remedies) };
  }

  /// A polyline whose points are vertices joined by edges, the case that changes nothing.
  Status followEdges(std::size_t c, Route& route)
  {
    const Polyline& polyline = this->Polylines[c];
    Indices off;
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      const Index vertex = this->vertex(c, i);
      if (vertex == none)
      {
        off.push_back(pointId(polyline, i));
        continue;
      }
      if (route.start == none)
      {
        route.start = vertex;
        route.firstPoint = i;
        continue;
      }
      const Index last = route.stretches.empty() ? route.start : route.stretches.back().back();
      const std::size_t before = route.points.empty() ? route.firstPoint : route.points.back();
      if (last == vertex)
      {
        continue;
      }
      if (off.empty() && this->Mesh.find(last, vertex) == none &&
        this->Mesh.find(vertex, last) == none)
      {
        const Indices ids{ pointId(polyline, before), pointId(polyline, i) };
        Status apart = this->Options.split
          ? Status()
          : this->betweenParts(
              c, ids, vertexPoint(this->Mesh, last), vertexPoint(this->Mesh, vertex));
        if (!apart.ok())
        {
          return apart;
        }
        return { StatusCode::CurveNotOnEdges,
          curveName(polyline, c) + ": between points " + std::to_string(ids[0]) + " and " +
            std::to_string(ids[1]) + " the curve is not an edge of the mesh",
          { ElementKind::CurvePoints, ids }, { Remedy::SplitTriangles, Remedy::FollowEdges } };
      }
      route.stretches.push_back({ last, vertex });
      route.points.push_back(i);
    }
    return off.empty() ? Status() : this->notAtVertices(c, off);
  }

  Status notAtVertices(std::size_t c, const Indices& points)
  {
    // Where the points lie matters for the message only.
    if (!this->Options.split)
    {
      std::vector<ClosestPoint> closest;
      Status status = this->locate(c, closest);
      if (!status.ok())
      {
        return status;
      }
    }
    return { StatusCode::CurveNotOnEdges,
      curveName(this->Polylines[c], c) + ": points " + listIds(points) +
        " are not at vertices of the mesh",
      { ElementKind::CurvePoints, points }, { Remedy::SplitTriangles, Remedy::FollowEdges } };
  }

  ImprintedSurface split(const std::vector<Route>& edgeRoutes, const std::vector<char>& alongEdges)
  {
    std::vector<std::vector<ClosestPoint>> located(this->Polylines.size());
    for (std::size_t c = 0; c < this->Polylines.size(); ++c)
    {
      Status status = alongEdges[c] ? Status() : this->locate(c, located[c]);
      if (!status.ok())
      {
        status.curve = static_cast<Index>(c);
        return refuse(std::move(status));
      }
    }
    // Rounding alone asks for some distance.
    SnapDistance snap(this->Mesh, std::max(1e-9, this->Options.snap));
    Indices failed;
    // Only triangles nearly without area need more than one round.
    for (int round = 0; round < 12; ++round)
    {
      std::vector<Route> routes = edgeRoutes;
      std::vector<SurfacePath> paths;
      for (std::size_t c = 0; c < this->Polylines.size(); ++c)
      {
        Status status = alongEdges[c] ? this->addEdgePaths(edgeRoutes[c], paths)
                                      : this->trace(c, located[c], snap, routes[c], paths);
        if (!status.ok())
        {
          status.curve = static_cast<Index>(c);
          return refuse(std::move(status));
        }
      }
      SplitSurface split = splitSurface(this->Mesh, snap, paths);
      failed = std::move(split.failed);
      if (failed.empty())
      {
        fillRoutes(split.chains, routes);
        return this->collect(std::move(split.surface), std::move(routes));
      }
      for (Index t : failed)
      {
        snap.enlarge(t);
      }
    }
    return refuse({ StatusCode::NumericalFailure,
      "triangles " + listIds(failed) + " are too thin to be split along the curves",
      { ElementKind::Cells, failed }, { Remedy::RemeshTriangles, Remedy::RaiseSnapTolerance } });
  }

  Status addEdgePaths(const Route& route, std::vector<SurfacePath>& paths) const
  {
    for (const Indices& edge : route.stretches)
    {
      Index h = this->Mesh.find(edge[0], edge[1]);
      h = h != none ? h : this->Mesh.find(edge[1], edge[0]);
      paths.push_back({ { vertexPoint(this->Mesh, edge[0]), vertexPoint(this->Mesh, edge[1]) },
        { h / 3 }, true });
    }
    return {};
  }

  /// One path per segment of the polyline, in the order of Route::points.
  Status trace(std::size_t c, const std::vector<ClosestPoint>& located, const SnapDistance& snap,
    Route& route, std::vector<SurfacePath>& paths) const
  {
    route = Route();
    SurfacePoint last;
    for (std::size_t i = 0; i < located.size(); ++i)
    {
      if (this->Execute.cancelled())
      {
        return { StatusCode::Cancelled, "cancelled", {} };
      }
      const Index vertex = this->vertex(c, i);
      const SurfacePoint here =
        vertex != none ? vertexPoint(this->Mesh, vertex) : snapToMesh(this->Mesh, snap, located[i]);
      if (i > 0 && !samePlace(here, last))
      {
        SurfacePath path = traceSegment(this->Mesh, snap, last, here);
        if (!path.arrived)
        {
          const Polyline& polyline = this->Polylines[c];
          Status apart =
            this->betweenParts(c, { pointId(polyline, i - 1), pointId(polyline, i) }, last, here);
          return apart.ok() ? this->strayed(c, i, path) : apart;
        }
        paths.push_back(std::move(path));
        route.points.push_back(i);
      }
      last = here;
    }
    return {};
  }

  /// Not Ok where two points of a polyline lie on parts of the surface that nothing joins.
  Status betweenParts(
    std::size_t c, const Indices& ids, const SurfacePoint& from, const SurfacePoint& to) const
  {
    Indices part;
    connectedParts(this->Mesh, {}, part);
    const Index one = part[trianglesAround(this->Mesh, from).front()];
    const Index other = part[trianglesAround(this->Mesh, to).front()];
    if (one == other)
    {
      return {};
    }
    const auto size = [&part](Index p) {
      return std::to_string(std::count(part.begin(), part.end(), p));
    };
    return { StatusCode::CurveLeavesSurface,
      curveName(this->Polylines[c], c) + ": points " + std::to_string(ids[0]) + " and " +
        std::to_string(ids[1]) + " lie on separate parts of the surface, of " + size(one) +
        " and " + size(other) + " triangles",
      { ElementKind::CurvePoints, ids }, { Remedy::RedrawCurve, Remedy::JoinByEdge } };
  }

  /// The segment that ends at point i cannot be followed.
  Status strayed(std::size_t c, std::size_t i, const SurfacePath& path) const
  {
    const Polyline& polyline = this->Polylines[c];
    const Indices ids{ pointId(polyline, i - 1), pointId(polyline, i) };
    const Point3& at = path.points.back().position;
    const std::string between = curveName(polyline, c) + ": between points " +
      std::to_string(ids[0]) + " and " + std::to_string(ids[1]);
    const std::string place =
      " (" + shortNumber(at.x()) + ", " + shortNumber(at.y()) + ", " + shortNumber(at.z()) + ")";
    const char* defect = path.atBoundary ? " the curve leaves the surface at"
                                         : " the curve cannot be followed over the surface from";
    SuggestedRemedies remedies{ Remedy::AddCurvePoints };
    if (path.atBoundary)
    {
      remedies.emplace_back(Remedy::EndAtBoundary);
    }
    return { StatusCode::CurveLeavesSurface, between + defect + place,
      { ElementKind::CurvePoints, ids }, std::move(remedies) };
  }

  static void fillRoutes(const std::vector<Indices>& chains, std::vector<Route>& routes)
  {
    std::size_t next = 0;
    for (Route& route : routes)
    {
      route.stretches.clear();
      for (std::size_t i = 0; i < route.points.size(); ++i)
      {
        route.stretches.push_back(chains[next++]);
      }
      route.start = route.stretches.empty() ? none : route.stretches[0][0];
    }
  }

  ImprintedSurface collect(ImprintedSurface result, std::vector<Route> routes) const
  {
    Status status = assembleCurves(result.mesh, this->Polylines, routes, result.curves);
    if (!status.ok())
    {
      return refuse(std::move(status));
    }
    result.routes = std::move(routes);
    return result;
  }

  const TriangleMesh& Mesh;
  const std::vector<Polyline>& Polylines;
  const ImprintOptions& Options;
  const Execution& Execute;
  double Diagonal;
  double Reach;          ///< greatest distance of a point from the surface
  SnapDistance AtVertex; ///< greatest distance of a point from the vertex that it is
  std::vector<std::size_t> First;
  Indices Vertices; ///< per point of all polylines
  std::optional<SheetLocator> Locator;
  Indices Parts; ///< by triangle, of what is joined; with the locator
};
}

ImprintedSurface imprintCurves(const TriangleMesh& mesh, const std::vector<Polyline>& polylines,
  const ImprintOptions& options, const Execution& execution)
{
  if (!(options.tolerance >= 0.0 && options.tolerance <= 1.0))
  {
    return refuse(
      { StatusCode::InvalidOption, "the imprint tolerance is " + shortNumber(options.tolerance), {},
        { { Remedy::Give, "a fraction from 0 to 1" } } });
  }
  if (!(options.snap >= 0.0 && options.snap <= 0.5))
  {
    return refuse({ StatusCode::InvalidOption, "the snap distance is " + shortNumber(options.snap),
      {}, { { Remedy::Give, "a fraction from 0 to 0.5" } } });
  }
  return withinMemory([&] { return Imprinter(mesh, polylines, options, execution).run(); });
}

void describeCurves(ImprintedSurface& imprinted, const std::vector<Polyline>& polylines)
{
  imprinted.curves.clear();
  Status status = checkPolylines(polylines);
  if (status.ok())
  {
    status = assembleCurves(imprinted.mesh, polylines, imprinted.routes, imprinted.curves);
  }
  if (!status.ok())
  {
    imprinted = refuse(std::move(status));
  }
}
}
