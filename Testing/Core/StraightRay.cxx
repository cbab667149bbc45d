// SPDX-License-Identifier: BSD-3-Clause
#include "StraightRay.h"

#include "Base/Types.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// How near a ray passes a vertex, as an angle, to be taken to meet it; and how small a weight of a
/// triangle's corner is taken for none.
constexpr double atRayVertex = 1e-12;

/// A triangle laid into the plane, from a half-edge along the first axis.
class FlatTriangle
{
public:
  FlatTriangle(const TriangleMesh& mesh, Index base)
    : Mesh(&mesh)
    , Base(base)
  {
    const Point3& from = mesh.point(mesh.from(base));
    const Point3 along = mesh.point(mesh.to(base)) - from;
    const Point3 apex = mesh.point(mesh.from(TriangleMesh::previous(base))) - from;
    const double length = along.norm();
    this->Corners = { Point2(0.0, 0.0), Point2(length, 0.0),
      Point2(along.dot(apex) / length, along.cross(apex).norm() / length) };
  }

  /// Half-edge k from the base on, and where it starts.
  Index halfedge(std::size_t k) const
  {
    return k == 0 ? this->Base
      : k == 1    ? TriangleMesh::next(this->Base)
                  : TriangleMesh::previous(this->Base);
  }
  const Point2& corner(std::size_t k) const { return this->Corners[k % 3]; }
  Index vertex(std::size_t k) const { return this->Mesh->from(this->halfedge(k % 3)); }

  Point2 place(const SurfacePoint& point) const
  {
    Point2 place = Point2::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      place += this->weight(point, k) * this->Corners[k];
    }
    return place;
  }
  Point2 direction(const Point3& vector) const
  {
    const Point3 along =
      (this->Mesh->point(this->vertex(1)) - this->Mesh->point(this->vertex(0))).normalized();
    const Point3 across = triangleNormal(*this->Mesh, this->Base / 3).cross(along);
    return Point2(along.dot(vector), across.dot(vector)).normalized();
  }
  SurfacePoint point(const Point2& place) const
  {
    std::array<double, 3> weights{};
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point2 side = this->corner(k + 1) - this->corner(k);
      const double weight = cross(side, place - this->corner(k));
      const auto opposite = static_cast<std::size_t>(TriangleMesh::previous(this->halfedge(k)) % 3);
      weights[opposite] = std::max(weight, 0.0);
      sum += weights[opposite];
    }
    for (double& weight : weights)
    {
      weight = weight < atRayVertex * sum ? 0.0 : weight / sum;
    }
    return pointOf(*this->Mesh, this->Base / 3, weights);
  }
  bool holds(std::size_t k, const SurfacePoint& point) const
  {
    const Index h = this->halfedge(k);
    return point.type == SurfacePointType::Vertex
      ? this->Mesh->from(h) == point.id || this->Mesh->to(h) == point.id
      : point.type == SurfacePointType::Edge && edgeOf(*this->Mesh, h) == point.id;
  }

private:
  double weight(const SurfacePoint& point, std::size_t k) const
  {
    const Index vertex = this->vertex(k);
    switch (point.type)
    {
      case SurfacePointType::Vertex:
        return vertex == point.id ? 1.0 : 0.0;
      case SurfacePointType::Edge:
        return vertex == this->Mesh->from(point.id) ? point.weights[0]
          : vertex == this->Mesh->to(point.id)      ? point.weights[1]
                                                    : 0.0;
      case SurfacePointType::Face:
        break;
    }
    return point.weights[static_cast<std::size_t>(this->halfedge(k) % 3)];
  }

  const TriangleMesh* Mesh;
  Index Base;
  std::array<Point2, 3> Corners;
};

/// How a ray leaves a triangle.
struct Exit
{
  std::size_t side = 3;   ///< none
  std::size_t corner = 3; ///< the one that it meets there; 3: none
  Point2 place = Point2::Zero();
  double distance = 0.0;
};

Exit exitOf(const FlatTriangle& flat, const Point2& place, const Point2& direction,
  const std::array<bool, 3>& entered)
{
  Exit exit;
  double leastMiss = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point2& from = flat.corner(k);
    const Point2& to = flat.corner(k + 1);
    const Point2 side = to - from;
    const double before = cross(direction, from - place);
    const double after = cross(direction, to - place);
    // The ray goes between the ends of one side, but for rounding.
    const double miss = std::max({ before, -after, 0.0 });
    if (entered[k] || !(cross(side, direction) < 0.0) || !(miss < leastMiss))
    {
      continue;
    }
    leastMiss = miss;
    const double fraction = after > before ? std::clamp(-before / (after - before), 0.0, 1.0) : 0.0;
    const std::size_t near = fraction < 0.5 ? k : (k + 1) % 3;
    const Point2 way = flat.corner(near) - place;
    const bool meets = std::abs(cross(direction, way)) <= atRayVertex * way.norm();
    exit.side = k;
    exit.corner = meets ? near : 3;
    exit.place = meets ? flat.corner(near) : from + fraction * side;
    exit.distance = direction.dot(exit.place - place);
  }
  return exit;
}

/// How a ray goes on behind a vertex, seen from the triangle that it comes from.
SurfaceDirection behindVertex(
  const TriangleMesh& mesh, Index vertex, Index triangle, const Point3& from)
{
  const PointDirections around(mesh, vertexPoint(mesh, vertex));
  const double back = around.angleTo(triangle, from);
  if (!around.atBoundary())
  {
    return around.at(back + 0.5 * around.total());
  }
  return back + pi < around.total() + PointDirections::Slack ? around.at(back + pi)
                                                             : around.at(back - pi);
}
}

StraightRay straightRay(const TriangleMesh& mesh, const SurfacePoint& start,
  const SurfaceDirection& direction, double length)
{
  StraightRay ray{ start, false };
  if (direction.triangle == none)
  {
    return ray;
  }
  FlatTriangle flat(mesh, 3 * direction.triangle);
  Point2 place = flat.place(start);
  Point2 heading = flat.direction(direction.vector);
  std::array<bool, 3> entered{ flat.holds(0, start), flat.holds(1, start), flat.holds(2, start) };
  double left = length;
  // A ray that winds round the surface for ever has no place on a curve drawn by hand.
  const Index most = 100 + 10 * mesh.triangleCount();
  for (Index steps = 0; steps < most; ++steps)
  {
    const Exit exit = exitOf(flat, place, heading, entered);
    if (exit.side == 3)
    {
      return ray;
    }
    if (exit.distance >= left * (1.0 - atRayVertex))
    {
      ray.end = flat.point(place + left * heading);
      ray.arrived = true;
      return ray;
    }
    left -= exit.distance;
    ray.end = flat.point(exit.place);
    const Index out = flat.halfedge(exit.side);
    if (exit.corner != 3)
    {
      const Index vertex = flat.vertex(exit.corner);
      ray.end = vertexPoint(mesh, vertex);
      const Point3 from = flat.point(place).position;
      const SurfaceDirection next = behindVertex(mesh, vertex, out / 3, from);
      if (next.triangle == none)
      {
        return ray;
      }
      flat = FlatTriangle(mesh, 3 * next.triangle);
      place = flat.place(ray.end);
      heading = flat.direction(next.vector);
      entered = { flat.holds(0, ray.end), flat.holds(1, ray.end), flat.holds(2, ray.end) };
      continue;
    }
    const Index twin = mesh.twin(out);
    if (twin == none)
    {
      return ray;
    }
    const Point2 along = (flat.corner(exit.side + 1) - flat.corner(exit.side)).normalized();
    const double behind = (flat.corner(exit.side + 1) - exit.place).norm();
    heading = Point2(-along.dot(heading), -cross(along, heading)).normalized();
    flat = FlatTriangle(mesh, twin);
    place = Point2(behind, 0.0);
    entered = { true, false, false };
  }
  return ray;
}
}
