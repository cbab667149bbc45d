// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PointDirections.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
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
