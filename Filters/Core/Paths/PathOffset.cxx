// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathOffset.h"

#include "Base/Memory.h"
#include "Paths/OffsetFront.h"
#include "Paths/OffsetLines.h"
#include "Paths/PathDistance.h"
#include "Paths/PathPoints.h"
#include "Surface/SurfaceTrace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace flattening
{
namespace
{
struct OffsetFault
{
  Point3 position = Point3::Zero();
  double distance = 0.0; ///< from the path, in space
};

constexpr double tooFar = 1.05; ///< of the distance; tangents of an arc's ends meet at 1.001

/// The place of an offset that lies farthest from its path, where that is more than a twentieth
/// farther than it should. Distances are those in space: none over the surface is shorter, so that
/// every fault that is found is one. What rounding in thin triangles can do at worst.
std::optional<OffsetFault> farthestFault(
  const SurfacePath& path, const std::vector<SurfacePath>& parts, double distance)
{
  OffsetFault worst;
  worst.distance = tooFar * distance;
  bool found = false;
  for (const SurfacePath& part : parts)
  {
    for (const SurfacePoint& point : part.points)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t leg = 0; leg + 1 < path.points.size() && nearest > worst.distance; ++leg)
      {
        nearest = std::min(nearest, footOnLeg(path, leg, point.position).gap);
      }
      if (nearest > worst.distance)
      {
        worst = { point.position, nearest };
        found = true;
      }
    }
  }
  return found ? std::optional(worst) : std::nullopt;
}

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
    const bool onLeft = distance > 0.0;
    SurfacePath source = withoutStops(path);
    source = onLeft ? std::move(source) : reversed(std::move(source));
    const double reach = std::abs(distance);
    const SurfacePath back = reversed(source);
    OffsetFront front(graph.mesh(), reach);
    const OffsetFamilies left(graph.mesh(), source);
    front.start(source, left.along(), true);
    front.start(back, OffsetFamilies(graph.mesh(), back).along(), false);
    front.start(source, left.caps(), false);
    if (!front.run())
    {
      offset.status = { StatusCode::NotConverged,
        "an offset at distance " + shortNumber(distance) + " goes too many ways round the surface",
        {}, { { Remedy::Give, "a shorter distance" } } };
      return offset;
    }
    const std::vector<OffsetLine> lines = offsetLines(graph.mesh(), front.windows(), reach);
    for (SurfacePath& part : joined(graph, lines, reach))
    {
      offset.parts.push_back(onLeft ? std::move(part) : reversed(std::move(part)));
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
          " from the curve in place of " + shortNumber(reach),
        {}, { Remedy::MendSlivers } };
    }
    return offset;
  });
}
}
