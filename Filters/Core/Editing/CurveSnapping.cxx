// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveSnapping.h"

#include "Editing/CurveDrawing.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// Of the longest edge there: half of it would leave no place between two vertices.
constexpr double vertexReach = 1.0 / 3.0;
/// Depth is guessed where the side is aimed at, but tells a near sheet from one far behind it.
constexpr double depthWeight = 0.1;

/// Keeps the nearest of what is offered within reach.
class Nearest
{
public:
  Nearest(const SurfacePoint& point, const SnapOptions& options)
    : Point(point)
    , Sight(options.sight)
    , Least(options.reach)
  {
    this->Found.point = point;
  }

  void offer(const SurfacePoint& candidate, SnapTarget target, Index curve = none)
  {
    const double distance = this->Sight.distance(candidate.position, this->Point.position);
    if (distance < this->Least)
    {
      this->Least = distance;
      this->Found = { candidate, target, curve };
    }
  }
  bool found() const { return this->Found.target != SnapTarget::Nothing; }
  const SnappedPoint& result() const { return this->Found; }

private:
  SurfacePoint Point;
  SightMetric Sight;
  double Least;
  SnappedPoint Found;
};

void offerNodes(
  const DrawingSurface& surface, const CurveSet& set, const SnapOptions& options, Nearest& nearest)
{
  for (std::size_t c = 0; c < set.curves.size(); ++c)
  {
    const EditedCurve& curve = *set.curves[c];
    const auto id = static_cast<Index>(c);
    for (std::size_t k = 0; k < curve.nodes.size() && id != options.exceptCurve; ++k)
    {
      const bool tip = curve.traits.type == CurveType::Dart && !curve.closed &&
        (k == 0 || k + 1 == curve.nodes.size()) && !onBoundary(surface.mesh(), curve.nodes[k]);
      if (tip ? options.dartTip : options.curve)
      {
        nearest.offer(curve.nodes[k], tip ? SnapTarget::DartTip : SnapTarget::Curve, id);
      }
    }
  }
}

void offerBoundary(
  const DrawingSurface& surface, const SightMetric& sight, const Point3& point, Nearest& nearest)
{
  const TriangleMesh& mesh = surface.mesh();
  for (const Index h : surface.boundary())
  {
    const double fraction =
      sight.nearestFraction(mesh.point(mesh.from(h)), mesh.point(mesh.to(h)), point);
    nearest.offer(crossingPoint(mesh, h, fraction), SnapTarget::Boundary);
  }
}

void offerCurves(const DrawingSurface& surface, const CurveSet& set, const SnapOptions& options,
  const Point3& point, Nearest& nearest)
{
  for (std::size_t c = 0; c < set.curves.size(); ++c)
  {
    const auto id = static_cast<Index>(c);
    if (id == options.exceptCurve)
    {
      continue;
    }
    Nearest onCurve = nearest;
    Point3 best = point;
    for (const SurfacePath& segment : set.curves[c]->segments)
    {
      for (std::size_t k = 1; k < segment.points.size(); ++k)
      {
        const Point3& a = segment.points[k - 1].position;
        const Point3& b = segment.points[k].position;
        SurfacePoint place;
        place.position = a + options.sight.nearestFraction(a, b, point) * (b - a);
        onCurve.offer(place, SnapTarget::Curve, id);
        best = onCurve.result().curve == id ? onCurve.result().point.position : best;
      }
    }
    if (onCurve.result().curve == id)
    {
      nearest.offer(surface.pointNear(best), SnapTarget::Curve, id);
    }
  }
}

/// The place in the point's triangle, or in that under its foot, where the surface meets the plane.
void offerMirror(const DrawingSurface& surface, const SightMetric& sight, const MirrorPlane& mirror,
  const SurfacePoint& point, Nearest& nearest)
{
  const TriangleMesh& mesh = surface.mesh();
  const Point3 foot = point.position - mirror.height(point.position) * mirror.normal;
  for (const Index t : trianglesAround(mesh, surface.pointNear(foot)))
  {
    Points3 crossings;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Point3& a = mesh.point(mesh.from(h));
      const Point3& b = mesh.point(mesh.to(h));
      const double below = mirror.height(a);
      const double above = mirror.height(b);
      if (below * above <= 0.0 && below != above)
      {
        crossings.push_back(a + below / (below - above) * (b - a));
      }
    }
    for (std::size_t k = 1; k < crossings.size(); ++k)
    {
      const Point3& a = crossings[0];
      const Point3& b = crossings[k];
      nearest.offer(surface.pointNear(a + sight.nearestFraction(a, b, point.position) * (b - a)),
        SnapTarget::MirrorPlane);
    }
  }
}

bool passes(const EditedCurve& curve, Index vertex)
{
  for (const SurfacePath& segment : curve.segments)
  {
    for (const SurfacePoint& point : segment.points)
    {
      if (point.type == SurfacePointType::Vertex && point.id == vertex)
      {
        return true;
      }
    }
  }
  return false;
}

/// The nearest vertex around a place; where it is on a line, one of the line's.
void offerVertices(
  const DrawingSurface& surface, const CurveSet& set, double reach, SnappedPoint& result)
{
  const TriangleMesh& mesh = surface.mesh();
  const SnappedPoint place = result;
  const auto fits = [&](Index v) {
    return place.target == SnapTarget::Nothing ||
      (place.target == SnapTarget::Boundary && mesh.onBoundary(v)) ||
      (place.target == SnapTarget::Curve &&
        passes(*set.curves[static_cast<std::size_t>(place.curve)], v));
  };
  double nearest = reach;
  for (const Index t : trianglesAround(mesh, place.point))
  {
    const double longest =
      std::max({ mesh.length(3 * t), mesh.length(3 * t + 1), mesh.length(3 * t + 2) });
    for (const Index v : mesh.triangle(t))
    {
      const double distance = (mesh.point(v) - place.point.position).norm();
      if (distance < std::min(nearest, vertexReach * longest) && fits(v))
      {
        nearest = distance;
        result = { vertexPoint(mesh, v), SnapTarget::Vertex, none };
      }
    }
  }
}
}

SightMetric::SightMetric(const Point3& direction)
  : Direction(direction.norm() > 0.0 ? Point3(direction.normalized()) : Point3(Point3::Zero()))
{
}

Point3 SightMetric::seen(const Point3& difference) const
{
  return difference - (1.0 - depthWeight) * this->Direction.dot(difference) * this->Direction;
}

double SightMetric::nearestFraction(const Point3& a, const Point3& b, const Point3& point) const
{
  const Point3 side = this->seen(b - a);
  const double square = side.squaredNorm();
  return square > 0.0 ? std::clamp(side.dot(this->seen(point - a)) / square, 0.0, 1.0) : 0.0;
}

SnappedPoint snapPoint(const DrawingSurface& surface, const CurveSet& curves,
  const SurfacePoint& point, const SnapOptions& options)
{
  Nearest points(point, options);
  offerNodes(surface, curves, options, points);
  for (const Index corner : options.corner ? surface.corners() : Indices())
  {
    points.offer(vertexPoint(surface.mesh(), corner), SnapTarget::Corner);
  }
  if (points.found())
  {
    return points.result();
  }
  Nearest lines(point, options);
  if (options.boundary)
  {
    offerBoundary(surface, options.sight, point.position, lines);
  }
  if (options.curve)
  {
    offerCurves(surface, curves, options, point.position, lines);
  }
  if (options.mirrorPlane && curves.mirror)
  {
    offerMirror(surface, options.sight, *curves.mirror, point, lines);
  }
  SnappedPoint result = lines.result();
  if (options.vertex)
  {
    offerVertices(surface, curves, options.reach, result);
  }
  return result;
}
}
