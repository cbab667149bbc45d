// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathDistance.h"

#include "Base/Memory.h"
#include "Paths/PathPoints.h"
#include "Paths/PointDirections.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
constexpr int narrowings = 40;
constexpr std::size_t mostFeet = 4;

/// Lengths of the ways from places along a path to a point.
class WaysFrom
{
public:
  WaysFrom(const PathGraph& graph, const SurfacePath& path, const SurfacePoint& point)
    : Graph(graph)
    , Path(path)
    , Point(point)
  {
    this->Places.push_back(0.0);
    for (std::size_t i = 0; i < path.triangles.size(); ++i)
    {
      this->Places.push_back(
        this->Places.back() + (path.points[i + 1].position - path.points[i].position).norm());
    }
  }

  double length() const { return this->Places.back(); }
  double place(const PathFoot& foot) const
  {
    return this->Places[foot.leg] +
      foot.along * (this->Places[foot.leg + 1] - this->Places[foot.leg]);
  }
  std::size_t legAt(double place) const
  {
    const auto after = std::upper_bound(this->Places.begin(), this->Places.end(), place);
    const auto leg = std::max<std::ptrdiff_t>(after - this->Places.begin() - 1, 0);
    return std::min(static_cast<std::size_t>(leg), this->Path.triangles.size() - 1);
  }
  SurfacePoint footAt(double place) const
  {
    const std::size_t leg = this->legAt(place);
    const double size = this->Places[leg + 1] - this->Places[leg];
    const double along =
      size > 0.0 ? std::clamp((place - this->Places[leg]) / size, 0.0, 1.0) : 0.0;
    return pointBetween(this->Graph.mesh(), this->Path.triangles[leg], this->Path.points[leg],
      this->Path.points[leg + 1], along);
  }
  StraightPath from(double place) const
  {
    return straightPath(this->Graph, this->footAt(place), this->Point);
  }
  /// The place near another from which the way is shortest, by golden sections.
  double nearest(double place) const
  {
    const StraightPath start = this->from(place);
    double low = std::max(place - start.length, 0.0);
    double high = std::min(place + start.length, this->length());
    for (int k = 0; k < narrowings && high - low > 1e-9 * this->length(); ++k)
    {
      const double a = high - inverseGoldenRatio * (high - low);
      const double b = low + inverseGoldenRatio * (high - low);
      const bool nearerA = this->from(a).length <= this->from(b).length;
      (nearerA ? high : low) = nearerA ? b : a;
    }
    const double found = 0.5 * (low + high);
    return this->from(found).length <= start.length ? found : place;
  }

private:
  const PathGraph& Graph;
  const SurfacePath& Path;
  const SurfacePoint& Point;
  std::vector<double> Places;
};

/// Whether a way leaves a leg on its left.
bool leavesLeft(
  const TriangleMesh& mesh, const SurfacePath& path, std::size_t leg, const SurfacePath& way)
{
  const PointDirections around(mesh, way.points.front());
  const SurfacePoint& foot = way.points.front();
  const bool atEnd = samePlace(foot, path.points[leg + 1]);
  const double along = atEnd ? around.angleTo(path.triangles[leg], path.points[leg].position) + pi
                             : around.angleTo(path.triangles[leg], path.points[leg + 1].position);
  const double out = around.angleTo(way.triangles.front(), way.points[1].position);
  return std::sin(out - along) > 0.0;
}
}

PathFoot footOnLeg(const SurfacePath& path, std::size_t leg, const Point3& point)
{
  const Point3& a = path.points[leg].position;
  const Point3 way = path.points[leg + 1].position - a;
  const double square = way.squaredNorm();
  const double s = square > 0.0 ? std::clamp(way.dot(point - a) / square, 0.0, 1.0) : 0.0;
  return { leg, s, (a + s * way - point).norm() };
}

std::vector<PathFoot> pathFeet(const SurfacePath& path, const Point3& point, double bound)
{
  std::vector<PathFoot> all;
  for (std::size_t i = 0; i < path.triangles.size(); ++i)
  {
    all.push_back(footOnLeg(path, i, point));
  }
  std::vector<PathFoot> feet;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i].gap < bound && (i == 0 || all[i].gap < all[i - 1].gap) &&
      (i + 1 == all.size() || all[i].gap <= all[i + 1].gap))
    {
      feet.push_back(all[i]);
    }
  }
  return feet;
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
    const WaysFrom ways(graph, path, point);
    std::vector<PathFoot> feet =
      pathFeet(path, point.position, std::numeric_limits<double>::infinity());
    std::sort(
      feet.begin(), feet.end(), [](const PathFoot& a, const PathFoot& b) { return a.gap < b.gap; });
    feet.resize(std::min(feet.size(), mostFeet));
    const auto offer = [&](double place) {
      StraightPath way = ways.from(place);
      if (way.status.refused())
      {
        found.status = way.status;
      }
      else if (!found.distance.way.path.arrived || way.length < found.distance.way.length)
      {
        found.distance.left =
          way.length > 0.0 && leavesLeft(graph.mesh(), path, ways.legAt(place), way.path);
        found.distance.way = std::move(way);
      }
    };
    // What is nearest over the surface may be farther in space than other ends.
    offer(0.0);
    offer(ways.length());
    for (const PathFoot& foot : feet)
    {
      if (found.distance.way.path.arrived && foot.gap >= found.distance.way.length)
      {
        break;
      }
      offer(ways.nearest(ways.place(foot)));
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
