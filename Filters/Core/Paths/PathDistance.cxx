// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathDistance.h"

#include "Base/Memory.h"
#include "Base/Types.h"
#include "Paths/PathPoints.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Golden sections of the place that a way starts from; and places that are tried.
constexpr int narrowings = 40;
constexpr std::size_t maxFeet = 4;

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
    feet.resize(std::min(feet.size(), maxFeet));
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

PointDirections::PointDirections(const TriangleMesh& mesh, const SurfacePoint& point)
  : Apex(point.position)
{
  if (point.type == SurfacePointType::Face)
  {
    this->add(mesh, 3 * point.id, 2.0 * pi);
    return;
  }
  if (point.type == SurfacePointType::Edge)
  {
    const Index twin = mesh.twin(point.id);
    this->add(mesh, point.id, pi);
    if (twin != none)
    {
      this->add(mesh, twin, pi);
    }
    this->Boundary = twin == none;
    return;
  }
  for (const Index h : VertexFan(mesh, point.id))
  {
    this->add(mesh, h, mesh.angle(h));
  }
  this->Boundary = mesh.onBoundary(point.id);
}

void PointDirections::add(const TriangleMesh& mesh, Index h, double size)
{
  Sector sector;
  sector.triangle = h / 3;
  sector.first = (mesh.point(mesh.to(h)) - mesh.point(mesh.from(h))).normalized();
  sector.across = triangleNormal(mesh, sector.triangle).cross(sector.first);
  sector.begin = this->total();
  sector.size = size;
  this->Sectors.push_back(sector);
}

double PointDirections::total() const
{
  return this->Sectors.empty() ? 0.0 : this->Sectors.back().begin + this->Sectors.back().size;
}

double PointDirections::angleTo(Index triangle, const Point3& target) const
{
  const auto sector = std::find_if(this->Sectors.begin(), this->Sectors.end(),
    [triangle](const Sector& candidate) { return candidate.triangle == triangle; });
  if (sector == this->Sectors.end())
  {
    return 0.0;
  }
  const Point3 way = target - this->Apex;
  double angle = std::atan2(sector->across.dot(way), sector->first.dot(way));
  // What lies on the sector's borders may be rounded to beyond them.
  const double beyond = 2.0 * pi - sector->size;
  angle = angle < -0.5 * beyond ? angle + 2.0 * pi : angle;
  return sector->begin + std::clamp(angle, 0.0, sector->size);
}

std::vector<DirectionRange> PointDirections::between(double first, double last) const
{
  const double all = this->total();
  const double turns = this->Boundary ? 0.0 : all * std::floor(first / all);
  std::vector<DirectionRange> ranges;
  for (double round = turns; round < last && (round == turns || !this->Boundary); round += all)
  {
    for (const Sector& sector : this->Sectors)
    {
      const double begin = std::max(first - round - sector.begin, 0.0);
      const double end = std::min(last - round - sector.begin, sector.size);
      if (end > begin)
      {
        ranges.push_back(
          { sector.triangle, sector.at(begin), sector.at(end), round + sector.begin + begin });
      }
    }
  }
  return ranges;
}

Point3 PointDirections::Sector::at(double angle) const
{
  return std::cos(angle) * this->first + std::sin(angle) * this->across;
}
}
