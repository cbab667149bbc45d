// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathOffset.h"

#include "Base/Memory.h"
#include "Paths/OffsetCheck.h"
#include "Paths/OffsetRays.h"
#include "Paths/OffsetTrimming.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Rays stand as near to each other as this fraction of the mean edge where the surface bends.
constexpr double finest = 0.25;
/// Between the tangents that make an arc: of the offset, and of what it is only cut by.
constexpr double widestArc = 5.0 * pi / 180.0;
constexpr double widestCut = 1.0 * pi / 180.0;
/// By how much, as a fraction, two rays may move apart and count as parallel.
constexpr double parallel = 1e-9;
/// Points nearer to each other, as a fraction of the distance, are one.
constexpr double samePoint = 1e-9;
constexpr int halvings = 60;

class OffsetDrawing
{
public:
  OffsetDrawing(const PathGraph& graph, const SurfacePath& path, double distance, double arc)
    : Graph(graph)
    , Mesh(graph.mesh())
    , Rays(graph.mesh(), path, distance, arc)
    , Distance(distance)
    , Closed(samePlace(path.points.front(), path.points.back()))
    , Step(finest * SnapDistance(graph.mesh(), 1.0).greatest())
  {
  }

  std::vector<SurfacePath> run() { return this->run(this->Rays.families()); }
  std::vector<SurfacePath> caps() { return this->run(this->Rays.caps()); }

  /// By how much, as a fraction, its points are nearer to their own feet than the distance, since
  /// rays pass vertices on either side.
  double shortcut() const { return this->Shortcut; }

private:
  std::vector<SurfacePath> run(const std::vector<RayFamily>& families)
  {
    for (const RayFamily& family : families)
    {
      this->Open = this->Open && !family.apart;
      double at = family.first;
      StraightRay before = this->ray(family, at);
      this->FromStart = this->FromStart || (this->Begun == 0 && before.arrived && !family.apart);
      ++this->Begun;
      this->take(before);
      for (const double next : this->Rays.places(family))
      {
        const StraightRay ray = this->ray(family, next);
        this->between(family, at, before, next, ray);
        at = next;
        before = ray;
      }
    }
    this->closeUp();
    return this->joined();
  }

  StraightRay ray(const RayFamily& family, double at)
  {
    StraightRay ray = this->Rays.ray(family, at);
    if (ray.arrived && family.leg)
    {
      this->measureShortcut(ray.end, this->Rays.foot(family, at));
    }
    return ray;
  }

  /// Takes the rays between two, the second with them; more of them where they move apart or
  /// together.
  void between(const RayFamily& family, double from, const StraightRay& first, double to,
    const StraightRay& last)
  {
    if (first.arrived != last.arrived)
    {
      this->meetBoundary(family, from, first, to, last);
      return;
    }
    const double width = family.width * std::abs(to - from);
    if (first.arrived && family.leg)
    {
      const StraightPath across = localStraightPath(this->Graph, first.end, last.end);
      const bool areParallel = !across.status.refused() &&
        std::abs(across.length - width) <= parallel * (width + this->Distance);
      const double middle = 0.5 * (from + to);
      if (!areParallel && width > this->Step)
      {
        const StraightRay ray = this->ray(family, middle);
        this->between(family, from, first, middle, ray);
        this->between(family, middle, ray, to, last);
        return;
      }
      if (!areParallel && !across.status.refused())
      {
        this->measureShortcut(pointAlong(this->Mesh, across.path, 0.5 * across.length),
          this->Rays.foot(family, middle));
      }
    }
    this->take(last);
  }

  void measureShortcut(const SurfacePoint& point, const SurfacePoint& foot)
  {
    const StraightPath back = localStraightPath(this->Graph, point, foot);
    this->Shortcut =
      std::max(this->Shortcut, back.status.refused() ? 0.0 : 1.0 - back.length / this->Distance);
  }

  /// The offset meets the boundary between two rays of which one arrives.
  void meetBoundary(const RayFamily& family, double from, const StraightRay& first, double to,
    const StraightRay& last)
  {
    double inside = first.arrived ? from : to;
    double outside = first.arrived ? to : from;
    StraightRay arrived = first.arrived ? first : last;
    StraightRay lost = first.arrived ? last : first;
    for (int k = 0; k < halvings; ++k)
    {
      const double middle = 0.5 * (inside + outside);
      const StraightRay ray = this->ray(family, middle);
      (ray.arrived ? inside : outside) = middle;
      (ray.arrived ? arrived : lost) = ray;
    }
    // Where the rays do not come to the boundary together, an edge of a hole stood in the way.
    const bool together =
      (arrived.end.position - lost.end.position).norm() <= parallel * this->Distance;
    const SurfacePoint end = together ? lost.end : arrived.end;
    if (first.arrived)
    {
      this->add(end);
      this->Open = false;
    }
    else
    {
      this->Open = false;
      this->add(end);
      this->add(last.end);
    }
  }

  void take(const StraightRay& ray)
  {
    if (ray.arrived)
    {
      this->add(ray.end);
    }
    else
    {
      this->Open = false;
    }
  }

  void add(const SurfacePoint& point)
  {
    if (!this->Open)
    {
      this->Runs.emplace_back();
      this->Open = true;
    }
    std::vector<SurfacePoint>& run = this->Runs.back();
    if (run.empty() || (run.back().position - point.position).norm() > samePoint * this->Distance)
    {
      run.push_back(point);
    }
  }

  /// What runs past the first point of a closed path is one.
  void closeUp()
  {
    if (!this->Closed || !this->FromStart || !this->Open)
    {
      return;
    }
    std::vector<SurfacePoint>& first = this->Runs.front();
    std::vector<SurfacePoint>& last = this->Runs.back();
    if ((last.back().position - first.front().position).norm() <= samePoint * this->Distance)
    {
      last.pop_back();
    }
    if (this->Runs.size() == 1)
    {
      const SurfacePoint start = first.front();
      first.push_back(start);
      return;
    }
    first.insert(first.begin(), last.begin(), last.end());
    this->Runs.pop_back();
  }

  std::vector<SurfacePath> joined() const
  {
    std::vector<SurfacePath> parts;
    for (const std::vector<SurfacePoint>& run : this->Runs)
    {
      SurfacePath part;
      part.points = { run.front() };
      for (std::size_t k = 1; k < run.size(); ++k)
      {
        const StraightPath step = localStraightPath(this->Graph, run[k - 1], run[k]);
        if (!step.status.refused())
        {
          append(part, step.path);
        }
      }
      if (!part.triangles.empty())
      {
        part.arrived = true;
        parts.push_back(std::move(part));
      }
    }
    return parts;
  }

  const PathGraph& Graph;
  const TriangleMesh& Mesh;
  OffsetRays Rays;
  double Distance;
  bool Closed;
  double Step;
  std::vector<std::vector<SurfacePoint>> Runs;
  bool Open = false;      ///< the last run goes on
  bool FromStart = false; ///< the first run has the first ray of all
  std::size_t Begun = 0;  ///< families
  double Shortcut = 0.0;  ///< the most that a ray is longer than the way back, as a fraction
};

Status checkOffset(const TriangleMesh& mesh, const SurfacePath& path, double distance)
{
  if (mesh.triangleCount() == 0)
  {
    return { StatusCode::EmptySurface, "there is no triangle to draw on", {},
      { Remedy::GiveTriangles } };
  }
  if (!liesOn(mesh, path) || !(lengthOf(path) > 0.0))
  {
    return { StatusCode::InvalidCurve, "the path of an offset is not on the surface, or a point",
      {}, { Remedy::RedrawCurve } };
  }
  if (!std::isfinite(distance) || distance == 0.0)
  {
    return { StatusCode::InvalidOption, "an offset has a finite distance that is not 0", {},
      { { Remedy::Give, "a distance that is not 0" } } };
  }
  return {};
}

/// Without legs of no length, which have no direction.
SurfacePath withoutStops(const SurfacePath& path)
{
  SurfacePath moving;
  moving.points = { path.points.front() };
  for (std::size_t i = 0; i < path.triangles.size(); ++i)
  {
    if (path.points[i + 1].position != moving.points.back().position)
    {
      moving.points.push_back(path.points[i + 1]);
      moving.triangles.push_back(path.triangles[i]);
    }
  }
  moving.arrived = true;
  return moving;
}
}

PathOffset offsetPath(const PathGraph& graph, const SurfacePath& path, double distance)
{
  return withinMemory([&] {
    PathOffset offset;
    offset.status = checkOffset(graph.mesh(), path, distance);
    if (!offset.status.ok())
    {
      return offset;
    }
    const bool left = distance > 0.0;
    SurfacePath source = withoutStops(path);
    source = left ? std::move(source) : reversed(std::move(source));
    const double reach = std::abs(distance);
    OffsetDrawing drawing(graph, source, reach, widestArc);
    const std::vector<SurfacePath> whole = drawing.run();
    const SurfacePath back = reversed(source);
    std::vector<SurfacePath> others = OffsetDrawing(graph, back, reach, widestCut).run();
    for (SurfacePath& cap : OffsetDrawing(graph, source, reach, widestCut).caps())
    {
      others.push_back(std::move(cap));
    }
    for (SurfacePath& part : trimmedOffset(graph, source, reach, drawing.shortcut(), whole, others))
    {
      offset.parts.push_back(left ? std::move(part) : reversed(std::move(part)));
    }
    if (offset.parts.empty())
    {
      offset.status = { StatusCode::CurveLeavesSurface,
        "there is no point of the surface at distance " + shortNumber(distance) +
          " on that side of the curve",
        {}, { { Remedy::Give, "a shorter distance, or one of the other sign" } } };
    }
    else if (const std::optional<OffsetFault> fault = farthestFault(source, offset.parts, reach))
    {
      const Point3& p = fault->position;
      offset.parts.clear();
      offset.status = { StatusCode::InvalidCurve,
        "the offset cannot be drawn: at (" + shortNumber(p.x()) + ", " + shortNumber(p.y()) + ", " +
          shortNumber(p.z()) + ") it would lie " + shortNumber(fault->distance) +
          " from the curve in place of " + shortNumber(reach) +
          ", since the triangles there are large beside the distance",
        {}, { { Remedy::Give, "a longer distance, or a surface with smaller triangles there" } } };
    }
    return offset;
  });
}
}
