// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/CurveImprint.h"

#include "Base/Memory.h"
#include "Imprint/CurvePlacement.h"
#include "Imprint/SurfaceSplit.h"
#include "Surface/SurfaceTrace.h"

#include <algorithm>

namespace flattening
{
namespace
{
ImprintedSurface refuse(Status status, std::size_t curve)
{
  ImprintedSurface result;
  status.curve = static_cast<Index>(curve);
  result.status = std::move(status);
  return result;
}

ImprintedSurface refuse(Status status)
{
  ImprintedSurface result;
  result.status = std::move(status);
  return result;
}

/// The triangles of the connected part of the surface that the point lies on, in order.
Indices partOf(const TriangleMesh& mesh, const SurfacePoint& point)
{
  std::vector<char> reached(static_cast<std::size_t>(mesh.triangleCount()), 0);
  Indices part = trianglesAround(mesh, point);
  for (const Index t : part)
  {
    reached[t] = 1;
  }
  for (std::size_t next = 0; next < part.size(); ++next)
  {
    for (Index h = 3 * part[next]; h < 3 * part[next] + 3; ++h)
    {
      const Index twin = mesh.twin(h);
      if (twin != none && !reached[twin / 3])
      {
        reached[twin / 3] = 1;
        part.push_back(twin / 3);
      }
    }
  }
  std::sort(part.begin(), part.end());
  return part;
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
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    result.originalTriangle[t] = t;
  }
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
    , Placement(mesh, polylines, options)
  {
  }

  ImprintedSurface run()
  {
    Status sound = checkPolylines(this->Polylines);
    if (!sound.ok())
    {
      return refuse(std::move(sound));
    }
    this->Placement.findVertices();
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
        return refuse(std::move(status), c);
      }
    }
    if (all)
    {
      ImprintedSurface result = keepMesh(this->Mesh);
      return this->collect(std::move(result), std::move(routes));
    }
    return this->split(routes, alongEdges);
  }

private:
  /// A polyline whose points are vertices joined by edges, the case that changes nothing.
  Status followEdges(std::size_t c, Route& route)
  {
    const Polyline& polyline = this->Polylines[c];
    Indices off;
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      const Index vertex = this->Placement.vertex(c, i);
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
            std::to_string(ids[1]) + " the curve is no edge of the mesh",
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
      Status status = this->Placement.locate(c, closest);
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
      Status status = alongEdges[c] ? Status() : this->Placement.locate(c, located[c]);
      if (!status.ok())
      {
        return refuse(std::move(status), c);
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
          return refuse(std::move(status), c);
        }
      }
      SplitSurface surface = splitSurface(this->Mesh, snap, paths);
      failed = std::move(surface.failed);
      if (failed.empty())
      {
        this->fillRoutes(surface, routes);
        ImprintedSurface result;
        result.mesh = std::move(surface.mesh);
        result.vertexSource = std::move(surface.vertexSource);
        result.originalTriangle = std::move(surface.originalTriangle);
        return this->collect(std::move(result), std::move(routes));
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
      const Index vertex = this->Placement.vertex(c, i);
      const SurfacePoint here =
        vertex != none ? vertexPoint(this->Mesh, vertex) : snapToMesh(this->Mesh, snap, located[i]);
      const bool same = i > 0 && here.type == last.type && here.id == last.id &&
        (here.type == SurfacePointType::Vertex || here.weights == last.weights);
      if (i > 0 && !same)
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
    const Indices part = partOf(this->Mesh, from);
    if (std::binary_search(part.begin(), part.end(), trianglesAround(this->Mesh, to).front()))
    {
      return {};
    }
    return { StatusCode::CurveLeavesSurface,
      curveName(this->Polylines[c], c) + ": points " + std::to_string(ids[0]) + " and " +
        std::to_string(ids[1]) + " lie on separate parts of the surface, of " +
        std::to_string(part.size()) + " and " + std::to_string(partOf(this->Mesh, to).size()) +
        " triangles",
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

  void fillRoutes(const SplitSurface& surface, std::vector<Route>& routes) const
  {
    std::size_t next = 0;
    for (Route& route : routes)
    {
      route.stretches.clear();
      for (std::size_t i = 0; i < route.points.size(); ++i)
      {
        route.stretches.push_back(surface.chains[next++]);
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
  CurvePlacement Placement;
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
