// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathDistance.h"

#include "Base/Memory.h"
#include "Base/Types.h"
#include "Paths/PathPoints.h"
#include "Paths/PointDirections.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Golden sections of the place that a way starts from; and places that are tried.
constexpr int narrowings = 40;
constexpr std::size_t mostFeet = 4;

/// Whether a way leaves a segment on its left.
bool leavesLeft(
  const TriangleMesh& mesh, const SurfacePath& path, std::size_t segment, const SurfacePath& way)
{
  const PointDirections around(mesh, way.points.front());
  const SurfacePoint& foot = way.points.front();
  const bool atEnd = samePlace(foot, path.points[segment + 1]);
  const double along = atEnd
    ? around.angleTo(path.triangles[segment], path.points[segment].position) + pi
    : around.angleTo(path.triangles[segment], path.points[segment + 1].position);
  const double out = around.angleTo(way.triangles.front(), way.points[1].position);
  return std::sin(out - along) > 0.0;
}
}

PathFoot footOnSegment(const SurfacePath& path, std::size_t segment, const Point3& point)
{
  const Point3& a = path.points[segment].position;
  const Point3 way = path.points[segment + 1].position - a;
  const double s = fractionAlong(a, path.points[segment + 1].position, point);
  return { segment, s, (a + s * way - point).norm() };
}

double gapInSpace(const SurfacePath& path, const Point3& point)
{
  double least = (path.points.front().position - point).norm();
  for (std::size_t segment = 0; segment < path.triangles.size(); ++segment)
  {
    least = std::min(least, footOnSegment(path, segment, point).gap);
  }
  return least;
}

PathDistance distanceFrom(
  const PathGraph& graph, const SurfacePath& path, const SurfacePoint& point)
{
  struct Outcome
  {
    PathDistance distance;
    Status status;
  };
  Outcome outcome = withinMemory([&] {
    Outcome found;
    const std::size_t segments = path.triangles.size();
    std::vector<double> places{ 0.0 };
    std::vector<PathFoot> all;
    for (std::size_t i = 0; i < segments; ++i)
    {
      places.push_back(
        places.back() + (path.points[i + 1].position - path.points[i].position).norm());
      all.push_back(footOnSegment(path, i, point.position));
    }
    const auto segmentAt = [&](double place) {
      const auto after = std::upper_bound(places.begin() + 1, places.end() - 1, place);
      return static_cast<std::size_t>(after - places.begin()) - 1;
    };
    const auto from = [&](double place) {
      const std::size_t segment = segmentAt(place);
      const double size = places[segment + 1] - places[segment];
      const double along =
        size > 0.0 ? std::clamp((place - places[segment]) / size, 0.0, 1.0) : 0.0;
      const SurfacePoint foot = pointBetween(graph.mesh(), path.triangles[segment],
        path.points[segment], path.points[segment + 1], along);
      return straightPath(graph, foot, point);
    };
    const auto offer = [&](double place) {
      StraightPath way = from(place);
      if (way.status.refused())
      {
        found.status = way.status;
      }
      else if (!found.distance.way.path.arrived || way.length < found.distance.way.length)
      {
        found.distance.left =
          way.length > 0.0 && leavesLeft(graph.mesh(), path, segmentAt(place), way.path);
        found.distance.way = std::move(way);
      }
    };
    // What is nearest over the surface may be farther in space than other ends.
    offer(0.0);
    offer(places.back());
    // Places that are nearer in space than their neighbours along the path.
    std::vector<PathFoot> feet;
    for (std::size_t i = 0; i < segments; ++i)
    {
      if ((i == 0 || all[i].gap < all[i - 1].gap) &&
        (i + 1 == segments || all[i].gap <= all[i + 1].gap))
      {
        feet.push_back(all[i]);
      }
    }
    std::sort(
      feet.begin(), feet.end(), [](const PathFoot& a, const PathFoot& b) { return a.gap < b.gap; });
    feet.resize(std::min(feet.size(), mostFeet));
    for (const PathFoot& foot : feet)
    {
      if (found.distance.way.path.arrived && foot.gap >= found.distance.way.length)
      {
        break;
      }
      const double place =
        places[foot.segment] + foot.along * (places[foot.segment + 1] - places[foot.segment]);
      const double reach = from(place).length;
      const double least =
        leastBetween(std::max(place - reach, 0.0), std::min(place + reach, places.back()),
          narrowings, 1e-9 * places.back(), [&](double at) { return from(at).length; });
      offer(place);
      offer(least);
    }
    return found;
  });
  if (!outcome.distance.way.path.arrived)
  {
    outcome.distance.way.status = outcome.status;
  }
  return outcome.distance;
}
}
