// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/KnotTurn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Of two sides that are equally sharp but for rounding the right one is taken.
constexpr double equalAngles = 1e-10;

double angleBetween(const Point3& a, const Point3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The half-edge of the triangle that leaves the vertex.
Index leaving(const TriangleMesh& mesh, Index triangle, Index vertex)
{
  Index h = 3 * triangle;
  while (mesh.from(h) != vertex)
  {
    ++h;
  }
  return h;
}

VertexDirection alongEdge(const TriangleMesh& mesh, Index halfedge, Index vertex)
{
  const Index twin = mesh.twin(halfedge);
  if (mesh.from(halfedge) == vertex)
  {
    return { halfedge, 0.0, true };
  }
  if (twin != none)
  {
    return { twin, 0.0, true };
  }
  // The last edge of a boundary fan has no half-edge that leaves the vertex.
  const Index last = TriangleMesh::next(halfedge);
  return { last, mesh.angle(last), false };
}
}

VertexDirection directionWithin(
  const TriangleMesh& mesh, const SurfacePoint& vertex, const SurfacePoint& other)
{
  const Index edge = commonEdge(mesh, vertex, other);
  if (edge != none)
  {
    return alongEdge(mesh, edge, vertex.id);
  }
  const Index h = leaving(mesh, commonTriangle(mesh, other, vertex), vertex.id);
  const Point3& apex = mesh.point(vertex.id);
  return { h, angleBetween(mesh.point(mesh.to(h)) - apex, other.position - apex), false };
}

VertexDirection leavingDirection(
  const TriangleMesh& mesh, const SurfacePoint& vertex, const PathLeg& leg, const SurfacePoint& to)
{
  if (leg.crossed.empty())
  {
    return directionWithin(mesh, vertex, to);
  }
  return { TriangleMesh::previous(leg.crossed.front()), leg.startAngle, false };
}

VertexDirection arrivingDirection(const TriangleMesh& mesh, const SurfacePoint& from,
  const PathLeg& leg, const SurfacePoint& vertex)
{
  if (leg.crossed.empty())
  {
    return directionWithin(mesh, vertex, from);
  }
  return { TriangleMesh::previous(mesh.twin(leg.crossed.back())), leg.endAngle, false };
}

KnotSide sectorBetween(
  const TriangleMesh& mesh, const VertexDirection& from, const VertexDirection& to)
{
  KnotSide side;
  if (from.halfedge == to.halfedge && from.angle <= to.angle)
  {
    side.angle = to.angle - from.angle;
    return side;
  }
  side.angle = mesh.angle(from.halfedge) - from.angle;
  for (Index h = from.halfedge;;)
  {
    const Index next = mesh.counterClockwise(h);
    if (next == none)
    {
      side.angle = std::numeric_limits<double>::infinity();
      side.crossed.clear();
      return side;
    }
    side.crossed.push_back(TriangleMesh::previous(h));
    h = next;
    if (h == to.halfedge)
    {
      break;
    }
    side.angle += mesh.angle(h);
  }
  side.angle += to.angle;
  if (to.alongEdge)
  {
    side.crossed.pop_back();
  }
  return side;
}

KnotSide sharperSide(const TriangleMesh& mesh, const SurfacePoint& before, const PathLeg& arriving,
  const SurfacePoint& knot, const PathLeg& leaving, const SurfacePoint& after)
{
  const VertexDirection in = arrivingDirection(mesh, before, arriving, knot);
  const VertexDirection out = leavingDirection(mesh, knot, leaving, after);
  KnotSide right = sectorBetween(mesh, in, out);
  KnotSide left = sectorBetween(mesh, out, in);
  if (right.angle <= left.angle + equalAngles)
  {
    return right;
  }
  left.left = true;
  std::reverse(left.crossed.begin(), left.crossed.end());
  for (Index& h : left.crossed)
  {
    h = mesh.twin(h);
  }
  return left;
}
}
