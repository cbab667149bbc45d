// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/Girth.h"

#include "Base/Memory.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Planes through two points that are tried, and how often the best is halved between its
/// neighbours.
constexpr int planes = 36;
constexpr int planeHalvings = 40;

/// How much longer a leg gets by a point.
double detour(const SurfacePath& path, std::size_t leg, const Point3& point)
{
  const Point3& from = path.points[leg].position;
  const Point3& to = path.points[leg + 1].position;
  return (point - from).norm() + (to - point).norm() - (to - from).norm();
}

/// Where a closed section goes through a point, by triangles and not by distance alone: a surface
/// may be folded. The place in the list, which gets the point where it is not in it.
/// \param taken the places of other points
bool findStation(const TriangleMesh& mesh, SurfacePath& path, const SurfacePoint& point,
  const std::vector<std::size_t>& taken, std::size_t& station)
{
  for (std::size_t i = 0; i < path.points.size(); ++i)
  {
    if (samePlace(path.points[i], point))
    {
      station = i;
      return true;
    }
  }
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i)
  {
    // An edge may lie in the plane, and be crossed anywhere.
    if (path.points[i].type == SurfacePointType::Edge && point.type == SurfacePointType::Edge &&
      path.points[i].id == point.id && std::count(taken.begin(), taken.end(), i) == 0)
    {
      path.points[i] = point;
      station = i;
      return true;
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.triangles.size(); ++i)
  {
    if (contains(mesh, path.triangles[i], point) && detour(path, i, point.position) < least)
    {
      least = detour(path, i, point.position);
      station = i + 1;
    }
  }
  if (!std::isfinite(least))
  {
    return false;
  }
  const auto at = static_cast<std::ptrdiff_t>(station);
  path.points.insert(path.points.begin() + at, point);
  path.triangles.insert(path.triangles.begin() + at, path.triangles[station - 1]);
  return true;
}

PlaneSection notClosed()
{
  PlaneSection refused;
  refused.status = { StatusCode::CurveLeavesSurface,
    "no closed section of the surface goes through the points of a girth", {},
    { Remedy::RedrawCurve } };
  return refused;
}

PlaneSection closedThrough(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points,
  const Point3& normal, std::vector<std::size_t>& stations)
{
  PlaneSection section = planeSection(mesh, points.front(), normal);
  if (!section.status.ok() || !section.closed)
  {
    return notClosed();
  }
  stations.assign(1, 0);
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    const std::size_t before = section.path.points.size();
    std::size_t station = 0;
    if (!findStation(mesh, section.path, points[k], stations, station))
    {
      return notClosed();
    }
    for (std::size_t& other : stations)
    {
      other += section.path.points.size() > before && other >= station ? 1 : 0;
    }
    stations.push_back(station);
  }
  if (points.size() == 3 && stations[1] > stations[2])
  {
    section.path = reversed(std::move(section.path));
    for (std::size_t k = 1; k < 3; ++k)
    {
      stations[k] = section.path.points.size() - 1 - stations[k];
    }
  }
  section.length = lengthOf(section.path);
  return section;
}
}

PlaneSection girth(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points,
  std::vector<std::size_t>* stations)
{
  return withinMemory([&] {
    std::vector<std::size_t> found;
    std::vector<std::size_t>& where = stations ? *stations : found;
    if (points.size() != 2 && points.size() != 3)
    {
      PlaneSection refused;
      refused.status = { StatusCode::InvalidOption,
        "a girth goes through two or three points, not " + std::to_string(points.size()), {},
        { { Remedy::Give, "two or three points" } } };
      return refused;
    }
    const Point3 along = points[1].position - points[0].position;
    if (points.size() == 3)
    {
      return closedThrough(
        mesh, points, along.cross(points[2].position - points[0].position), where);
    }
    if (!(along.norm() > 0.0))
    {
      return notClosed();
    }
    const Point3 first = along.unitOrthogonal();
    const Point3 second = along.normalized().cross(first);
    const auto tape = [&](double angle) {
      std::vector<std::size_t> places;
      const PlaneSection section =
        closedThrough(mesh, points, std::cos(angle) * first + std::sin(angle) * second, places);
      return section.status.ok() ? section.length : std::numeric_limits<double>::infinity();
    };
    double best = 0.0;
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < planes; ++k)
    {
      const double length = tape(pi * k / planes);
      if (length < shortest)
      {
        shortest = length;
        best = pi * k / planes;
      }
    }
    double low = best - pi / planes;
    double high = best + pi / planes;
    for (int k = 0; k < planeHalvings; ++k)
    {
      const double a = high - inverseGoldenRatio * (high - low);
      const double b = low + inverseGoldenRatio * (high - low);
      (tape(a) <= tape(b) ? high : low) = tape(a) <= tape(b) ? b : a;
    }
    const double refined = tape(0.5 * (low + high)) <= shortest ? 0.5 * (low + high) : best;
    return closedThrough(
      mesh, points, std::cos(refined) * first + std::sin(refined) * second, where);
  });
}
}
