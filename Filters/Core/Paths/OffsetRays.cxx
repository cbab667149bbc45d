// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetRays.h"

#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
constexpr double straightCorner = 1e-9; // radians
}

OffsetRays::OffsetRays(
  const TriangleMesh& mesh, const SurfacePath& path, double distance, double widestArc)
  : Mesh(mesh)
  , Path(path)
  , Distance(distance)
  , WidestArc(widestArc)
  , Closed(samePlace(path.points.front(), path.points.back()))
{
}

std::vector<RayFamily> OffsetRays::families() const
{
  std::vector<RayFamily> all;
  const std::size_t legs = this->Path.triangles.size();
  for (std::size_t i = 0; i < legs; ++i)
  {
    const double length =
      (this->Path.points[i + 1].position - this->Path.points[i].position).norm();
    i > 0 || this->Closed ? this->addCorner(i, all) : this->addFromBoundary(i, all);
    all.push_back({ i, true, 0.0, 1.0, length, false });
  }
  if (!this->Closed)
  {
    this->addToBoundary(legs, all);
  }
  return all;
}

std::vector<RayFamily> OffsetRays::caps() const
{
  std::vector<RayFamily> caps;
  const std::size_t legs = this->Path.triangles.size();
  for (const std::size_t i : { std::size_t{ 0 }, legs })
  {
    const PointDirections around(this->Mesh, this->Path.points[i]);
    if (this->Closed || around.atBoundary())
    {
      continue;
    }
    const double leg = i == 0 ? this->outAngle(around, i) : this->inAngle(around, i);
    const double last = leg + 0.5 * pi;
    const double first = leg + around.total() - 0.5 * pi;
    if (first > last)
    {
      caps.push_back({ i, false, first, last, 0.0, true });
    }
  }
  return caps;
}

double OffsetRays::outAngle(const PointDirections& around, std::size_t i) const
{
  return around.angleTo(this->Path.triangles[i], this->Path.points[i + 1].position);
}
double OffsetRays::inAngle(const PointDirections& around, std::size_t i) const
{
  const std::size_t before = (i == 0 ? this->Path.triangles.size() : i) - 1;
  return around.angleTo(this->Path.triangles[before], this->Path.points[before].position);
}

/// Round point i from the boundary, where it lies there, to the right angle with the leg.
void OffsetRays::addFromBoundary(std::size_t i, std::vector<RayFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double right = this->outAngle(around, i) + 0.5 * pi;
  if (around.atBoundary() && right < around.total())
  {
    all.push_back({ i, false, around.total(), right, 0.0, true });
  }
}
/// From the right angle with the leg before point i to the boundary.
void OffsetRays::addToBoundary(std::size_t i, std::vector<RayFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double right = this->inAngle(around, i) - 0.5 * pi;
  if (around.atBoundary() && right > 0.0)
  {
    all.push_back({ i, false, right, 0.0, 0.0, false });
  }
}
void OffsetRays::addCorner(std::size_t i, std::vector<RayFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double out = this->outAngle(around, i);
  double in = this->inAngle(around, i);
  if (around.atBoundary() && in <= out)
  {
    this->addToBoundary(i, all);
    this->addFromBoundary(i, all);
    return;
  }
  in = in <= out ? in + around.total() : in;
  if (in - out > pi + straightCorner)
  {
    all.push_back({ i, false, in - 0.5 * pi, out + 0.5 * pi, 0.0, false });
  }
}

/// How far an arc's tangents reach, as an angle.
double OffsetRays::halfArc(const RayFamily& family) const
{
  const double span = std::abs(family.last - family.first);
  return 0.5 * span / std::max(1.0, std::ceil(span / this->WidestArc - straightCorner));
}

std::vector<double> OffsetRays::places(const RayFamily& family) const
{
  std::vector<double> places;
  const double half = this->halfArc(family);
  const double span = std::abs(family.last - family.first);
  const double sense = family.last < family.first ? -1.0 : 1.0;
  for (double at = half; !family.leg && half > 0.0 && at < span; at += 2.0 * half)
  {
    places.push_back(family.first + sense * at);
  }
  places.push_back(family.last);
  return places;
}
double OffsetRays::reachOf(const RayFamily& family, double at) const
{
  const double half = this->halfArc(family);
  const double way = std::abs(at - family.first);
  const double touching = half > 0.0 ? 2.0 * half * std::round(way / (2.0 * half)) : way;
  return this->Distance / std::cos(way - touching);
}

SurfacePoint OffsetRays::foot(const RayFamily& family, double at) const
{
  const SurfacePoint& start = this->Path.points[family.point];
  return family.leg ? pointBetween(this->Mesh, this->Path.triangles[family.point], start,
                        this->Path.points[family.point + 1], at)
                    : start;
}

StraightRay OffsetRays::ray(const RayFamily& family, double at) const
{
  const SurfacePoint foot = this->foot(family, at);
  const PointDirections around(this->Mesh, foot);
  if (!family.leg)
  {
    return straightRay(this->Mesh, foot, around.at(at), this->reachOf(family, at));
  }
  const Index triangle = this->Path.triangles[family.point];
  const double left = at < 1.0
    ? around.angleTo(triangle, this->Path.points[family.point + 1].position) + 0.5 * pi
    : around.angleTo(triangle, this->Path.points[family.point].position) - 0.5 * pi;
  return straightRay(this->Mesh, foot, around.at(left), this->Distance);
}
}
