// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathOffset.h"

#include "Base/Memory.h"
#include "Base/Types.h"
#include "Paths/OffsetLines.h"
#include "Paths/PathDistance.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"
#include "Surface/SurfaceTrace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
/// Ends of lines that are one, as a fraction of the distance: where narrow fans and merged windows
/// end, lines have gaps.
constexpr double sameEnd = 1e-4;
/// Parts of an offset that are shorter, as a fraction of the distance, are left out.
constexpr double shortestPart = 1e-6;
constexpr double tooFar = 1.05; ///< of the distance

/// Which line goes on where each one ends.
std::vector<std::size_t> successors(const std::vector<OffsetLine>& lines, double distance)
{
  // Along a direction that no row of a mesh is likely to be at right angles to.
  const auto height = [](const SurfacePoint& p) { return p.position.dot(Point3(0.48, 0.6, 0.64)); };
  std::vector<std::pair<double, std::size_t>> starts;
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    starts.emplace_back(height(lines[k].from), k);
  }
  std::sort(starts.begin(), starts.end());
  const double reach = sameEnd * distance;
  // The nearest first, so that none takes what belongs to another.
  std::vector<std::tuple<double, std::size_t, std::size_t>> gaps;
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const double end = height(lines[k].to);
    for (auto start = std::lower_bound(
           starts.begin(), starts.end(), std::make_pair(end - reach, std::size_t{ 0 }));
         start != starts.end() && start->first <= end + reach; ++start)
    {
      const double gap = (lines[start->second].from.position - lines[k].to.position).norm();
      if (gap <= reach && start->second != k)
      {
        gaps.emplace_back(gap, k, start->second);
      }
    }
  }
  std::sort(gaps.begin(), gaps.end());
  std::vector<std::size_t> next(lines.size(), lines.size());
  std::vector<char> follows(lines.size(), 0);
  for (const auto& [gap, before, after] : gaps)
  {
    if (next[before] == lines.size() && !follows[after])
    {
      next[before] = after;
      follows[after] = 1;
    }
  }
  return next;
}

/// Leads a path on to where the next line starts: both are one point, but for rounding, found in
/// two triangles. \param triangle of the line
void leadTo(const PathGraph& graph, Index triangle, SurfacePoint& start, SurfacePath& path)
{
  const TriangleMesh& mesh = graph.mesh();
  if (contains(mesh, triangle, path.points.back()))
  {
    start = path.points.back();
  }
  else if (contains(mesh, path.triangles.back(), start))
  {
    path.points.back() = start;
  }
  else
  {
    const StraightPath step = localStraightPath(graph, path.points.back(), start);
    if (!step.status.refused())
    {
      append(path, step.path);
    }
  }
}

/// Lines of which one starts where another ends are one path.
std::vector<SurfacePath> joined(
  const PathGraph& graph, std::vector<OffsetLine> lines, double distance)
{
  const std::vector<std::size_t> next = successors(lines, distance);
  std::vector<char> follows(lines.size() + 1, 0);
  for (const std::size_t after : next)
  {
    follows[after] = 1;
  }
  std::vector<SurfacePath> paths;
  std::vector<char> taken(lines.size() + 1, 0);
  taken.back() = 1;
  for (const bool closed : { false, true })
  {
    for (std::size_t first = 0; first < lines.size(); ++first)
    {
      SurfacePath path;
      for (std::size_t k = closed || !follows[first] ? first : lines.size(); !taken[k]; k = next[k])
      {
        taken[k] = 1;
        if (path.points.empty())
        {
          path.points = { lines[k].from };
        }
        else
        {
          leadTo(graph, lines[k].triangle, lines[k].from, path);
        }
        path.points.push_back(lines[k].to);
        path.triangles.push_back(lines[k].triangle);
      }
      if (closed && !path.points.empty())
      {
        leadTo(graph, path.triangles.front(), path.points.front(), path);
      }
      if (lengthOf(path) > shortestPart * distance)
      {
        path.arrived = true;
        paths.push_back(std::move(path));
      }
    }
  }
  return paths;
}

/// The place of an offset that lies farthest from its path in space, where that is more than a
/// twentieth too far: what rounding in thin triangles can do at worst. No way over the surface is
/// shorter than that in space, so that every fault that is found is one.
Status checkDistance(
  const SurfacePath& path, const std::vector<SurfacePath>& parts, double distance)
{
  double worst = tooFar * distance;
  Status status;
  for (const SurfacePath& part : parts)
  {
    for (const SurfacePoint& point : part.points)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < path.triangles.size() && nearest > worst; ++k)
      {
        nearest = std::min(nearest, footOnSegment(path, k, point.position).gap);
      }
      if (nearest > worst)
      {
        worst = nearest;
        const Point3& p = point.position;
        status = { StatusCode::InvalidCurve,
          "the offset cannot be drawn: at (" + shortNumber(p.x()) + ", " + shortNumber(p.y()) +
            ", " + shortNumber(p.z()) + ") it would lie " + shortNumber(nearest) +
            " from the curve instead of " + shortNumber(distance),
          {}, { Remedy::MendSlivers } };
      }
    }
  }
  return status;
}

Status checkOffset(const TriangleMesh& mesh, const SurfacePath& path, double distance)
{
  if (Status status = checkPoints(mesh, {}, ""); !status.ok())
  {
    return status;
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

/// Without segments of no length, which have no direction.
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
    const std::optional<std::vector<OffsetLine>> lines = offsetLines(graph.mesh(), source, reach);
    if (!lines)
    {
      offset.status = { StatusCode::NotConverged,
        "an offset at distance " + shortNumber(distance) + " goes too many ways round the surface",
        {}, { { Remedy::Give, "a shorter distance" } } };
      return offset;
    }
    for (SurfacePath& part : joined(graph, *lines, reach))
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
    else if (offset.status = checkDistance(source, offset.parts, reach); !offset.status.ok())
    {
      offset.parts.clear();
    }
    return offset;
  });
}
}
