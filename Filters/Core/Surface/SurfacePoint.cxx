// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/SurfacePoint.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// How near to the end of an edge a crossing is taken for the vertex, as a fraction of the edge.
constexpr double atVertex = 1e-13;
}

SnapDistance::SnapDistance(const TriangleMesh& mesh, double fraction)
  : Mesh(mesh)
  , Fraction(fraction)
{
  Index edges = 0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (edgeOf(mesh, h) == h)
    {
      this->Mean += mesh.length(h);
      ++edges;
    }
  }
  this->Mean /= std::max<Index>(edges, 1);
}

double SnapDistance::longestEdge(Index triangle) const
{
  return std::max({ this->Mesh.length(3 * triangle), this->Mesh.length(3 * triangle + 1),
    this->Mesh.length(3 * triangle + 2) });
}

double SnapDistance::ofFace(Index triangle) const
{
  const double longest = this->longestEdge(triangle);
  const double distance = this->Fraction * std::min(this->Mean, longest);
  const auto factor = this->Factors.find(triangle);
  return factor == this->Factors.end() ? distance
                                       : std::min(distance * factor->second, 0.5 * longest);
}

double SnapDistance::ofEdge(Index halfedge) const
{
  const Index twin = this->Mesh.twin(halfedge);
  const double here = this->ofFace(halfedge / 3);
  return twin == none ? here : std::max(here, this->ofFace(twin / 3));
}

double SnapDistance::ofVertex(Index vertex) const
{
  double distance = 0.0;
  if (!(this->Fraction > 0.0))
  {
    return distance;
  }
  for (Index t : trianglesAround(this->Mesh, vertexPoint(this->Mesh, vertex)))
  {
    distance = std::max(distance, this->ofFace(t));
  }
  return distance;
}

void SnapDistance::enlarge(Index triangle)
{
  this->Factors.emplace(triangle, 1.0).first->second *= 8.0;
}

Index edgeOf(const TriangleMesh& mesh, Index halfedge)
{
  const Index twin = mesh.twin(halfedge);
  return twin == none ? halfedge : std::min(halfedge, twin);
}

SurfacePoint vertexPoint(const TriangleMesh& mesh, Index vertex)
{
  return { SurfacePointType::Vertex, vertex, { 1.0, 0.0, 0.0 }, mesh.point(vertex) };
}

SurfacePoint edgePoint(const TriangleMesh& mesh, Index halfedge, double fraction)
{
  const Index low = edgeOf(mesh, halfedge);
  const double s = low == halfedge ? fraction : 1.0 - fraction;
  return { SurfacePointType::Edge, low, { 1.0 - s, s, 0.0 },
    (1.0 - s) * mesh.point(mesh.from(low)) + s * mesh.point(mesh.to(low)) };
}

SurfacePoint crossingPoint(const TriangleMesh& mesh, Index halfedge, double fraction)
{
  return fraction < atVertex    ? vertexPoint(mesh, mesh.from(halfedge))
    : fraction > 1.0 - atVertex ? vertexPoint(mesh, mesh.to(halfedge))
                                : edgePoint(mesh, halfedge, fraction);
}

SurfacePoint snapToMesh(
  const TriangleMesh& mesh, const SnapDistance& snap, const ClosestPoint& closest)
{
  const Index t = closest.triangle;
  const Triangle& corners = mesh.triangle(t);
  auto distanceTo = [&](Index v) { return (mesh.point(v) - closest.position).norm(); };
  const Index nearest = *std::min_element(corners.begin(), corners.end(),
    [&](Index v, Index w) { return distanceTo(v) < distanceTo(w); });
  if (distanceTo(nearest) <= snap.ofVertex(nearest))
  {
    return vertexPoint(mesh, nearest);
  }
  Index edge = none;
  double fraction = 0.0;
  double least = 0.0;
  for (Index h = 3 * t; h < 3 * t + 3; ++h)
  {
    const Point3& from = mesh.point(mesh.from(h));
    const Point3 side = mesh.point(mesh.to(h)) - from;
    const double s = std::clamp(side.dot(closest.position - from) / side.squaredNorm(), 0.0, 1.0);
    const double distance = (from + s * side - closest.position).norm();
    if (distance <= snap.ofEdge(h) && (edge == none || distance < least))
    {
      edge = h;
      fraction = s;
      least = distance;
    }
  }
  if (edge == none)
  {
    return { SurfacePointType::Face, t, closest.weights, closest.position };
  }
  const SurfacePoint point = edgePoint(mesh, edge, fraction);
  const double length = mesh.length(point.id);
  const bool atFrom = point.weights[1] < 0.5;
  const Index end = atFrom ? mesh.from(point.id) : mesh.to(point.id);
  const double toEnd = length * (atFrom ? point.weights[1] : point.weights[0]);
  return toEnd <= snap.ofVertex(end) ? vertexPoint(mesh, end) : point;
}

Point3 nearestOnBoundary(const TriangleMesh& mesh, const Point3& point)
{
  Point3 best = point;
  double least = std::numeric_limits<double>::infinity();
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      const Point3& from = mesh.point(mesh.from(h));
      const Point3& to = mesh.point(mesh.to(h));
      const Point3 here = from + fractionAlong(from, to, point) * (to - from);
      if ((point - here).norm() < least)
      {
        least = (point - here).norm();
        best = here;
      }
    }
  }
  return best;
}

Points3 positionsOf(const std::vector<SurfacePoint>& points)
{
  Points3 positions;
  positions.reserve(points.size());
  for (const SurfacePoint& point : points)
  {
    positions.push_back(point.position);
  }
  return positions;
}

bool samePlace(const SurfacePoint& a, const SurfacePoint& b)
{
  return a.type == b.type && a.id == b.id &&
    (a.type == SurfacePointType::Vertex || a.weights == b.weights);
}

Indices trianglesAround(const TriangleMesh& mesh, const SurfacePoint& point)
{
  Indices triangles;
  if (point.type == SurfacePointType::Face)
  {
    triangles.push_back(point.id);
  }
  else if (point.type == SurfacePointType::Edge)
  {
    triangles.push_back(point.id / 3);
    if (mesh.twin(point.id) != none)
    {
      triangles.push_back(mesh.twin(point.id) / 3);
    }
  }
  else
  {
    for (Index h : VertexFan(mesh, point.id))
    {
      triangles.push_back(h / 3);
    }
  }
  return triangles;
}

bool contains(const TriangleMesh& mesh, Index triangle, const SurfacePoint& point)
{
  switch (point.type)
  {
    case SurfacePointType::Face:
      return point.id == triangle;
    case SurfacePointType::Edge:
      return point.id / 3 == triangle ||
        (mesh.twin(point.id) != none && mesh.twin(point.id) / 3 == triangle);
    case SurfacePointType::Vertex:
      break;
  }
  const Triangle& corners = mesh.triangle(triangle);
  return std::find(corners.begin(), corners.end(), point.id) != corners.end();
}

bool edgeHolds(const TriangleMesh& mesh, Index halfedge, const SurfacePoint& point)
{
  return point.type == SurfacePointType::Vertex
    ? mesh.from(halfedge) == point.id || mesh.to(halfedge) == point.id
    : point.type == SurfacePointType::Edge && edgeOf(mesh, halfedge) == point.id;
}

bool onBoundary(const TriangleMesh& mesh, const SurfacePoint& point)
{
  return point.type == SurfacePointType::Vertex
    ? mesh.onBoundary(point.id)
    : point.type == SurfacePointType::Edge && mesh.twin(point.id) == none;
}

Index commonEdge(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  if (a.type == SurfacePointType::Face || b.type == SurfacePointType::Face)
  {
    return none;
  }
  if (a.type == SurfacePointType::Vertex && b.type == SurfacePointType::Vertex)
  {
    const Index h = mesh.find(a.id, b.id);
    return h != none ? h : mesh.find(b.id, a.id);
  }
  if (a.type == SurfacePointType::Edge && b.type == SurfacePointType::Edge)
  {
    return a.id == b.id ? a.id : none;
  }
  const SurfacePoint& vertex = a.type == SurfacePointType::Vertex ? a : b;
  const Index edge = a.type == SurfacePointType::Vertex ? b.id : a.id;
  return edgeHolds(mesh, edge, vertex) ? edge : none;
}

Index commonTriangle(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  for (Index t : trianglesAround(mesh, a))
  {
    if (contains(mesh, t, b))
    {
      return t;
    }
  }
  return none;
}

Point3 triangleNormal(const TriangleMesh& mesh, Index triangle)
{
  return areaVector(mesh.points(), mesh.triangle(triangle)).stableNormalized();
}

Point3 normalAt(const TriangleMesh& mesh, const SurfacePoint& point)
{
  Point3 normal = Point3::Zero();
  for (Index t : trianglesAround(mesh, point))
  {
    double weight = 1.0;
    if (point.type == SurfacePointType::Vertex)
    {
      const Triangle& c = mesh.triangle(t);
      const auto corner = std::find(c.begin(), c.end(), point.id) - c.begin();
      weight = mesh.angle(3 * t + static_cast<Index>(corner));
    }
    normal += weight * triangleNormal(mesh, t);
  }
  const double size = normal.norm();
  return size > 0.0 ? Point3(normal / size) : triangleNormal(mesh, trianglesAround(mesh, point)[0]);
}
}
