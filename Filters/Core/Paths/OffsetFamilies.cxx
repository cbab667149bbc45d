// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetFamilies.h"

#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
constexpr double straightCorner = 1e-9; // radians
}

OffsetFamilies::OffsetFamilies(const TriangleMesh& mesh, const SurfacePath& path)
  : Mesh(mesh)
  , Path(path)
  , Closed(samePlace(path.points.front(), path.points.back()))
{
}

std::vector<OffsetFamily> OffsetFamilies::along() const
{
  std::vector<OffsetFamily> all;
  const std::size_t legs = this->Path.triangles.size();
  for (std::size_t i = 0; i < legs; ++i)
  {
    i > 0 || this->Closed ? this->addCorner(i, all) : this->addFromBoundary(i, all);
    all.push_back({ i, true });
  }
  if (!this->Closed)
  {
    this->addToBoundary(legs, all);
  }
  return all;
}

std::vector<OffsetFamily> OffsetFamilies::caps() const
{
  std::vector<OffsetFamily> caps;
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
      caps.push_back({ i, false, first, last });
    }
  }
  return caps;
}

double OffsetFamilies::outAngle(const PointDirections& around, std::size_t i) const
{
  return around.angleTo(this->Path.triangles[i], this->Path.points[i + 1].position);
}
double OffsetFamilies::inAngle(const PointDirections& around, std::size_t i) const
{
  const std::size_t before = (i == 0 ? this->Path.triangles.size() : i) - 1;
  return around.angleTo(this->Path.triangles[before], this->Path.points[before].position);
}

/// Round point i from the boundary, where it lies there, to the right angle with the leg.
void OffsetFamilies::addFromBoundary(std::size_t i, std::vector<OffsetFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double right = this->outAngle(around, i) + 0.5 * pi;
  if (around.atBoundary() && right < around.total())
  {
    all.push_back({ i, false, around.total(), right });
  }
}
/// From the right angle with the leg before point i to the boundary.
void OffsetFamilies::addToBoundary(std::size_t i, std::vector<OffsetFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double right = this->inAngle(around, i) - 0.5 * pi;
  if (around.atBoundary() && right > 0.0)
  {
    all.push_back({ i, false, right, 0.0 });
  }
}
void OffsetFamilies::addCorner(std::size_t i, std::vector<OffsetFamily>& all) const
{
  const PointDirections around(this->Mesh, this->Path.points[i]);
  const double out = this->outAngle(around, i);
  double in = this->inAngle(around, i);
  // A path that turns back is gone round on both its sides, whatever rounding makes of its angle.
  if (around.atBoundary() && in <= out + straightCorner)
  {
    this->addToBoundary(i, all);
    this->addFromBoundary(i, all);
    return;
  }
  in = in <= out ? in + around.total() : in;
  in = in <= out + straightCorner ? in + around.total() : in;
  if (in - out > pi + straightCorner)
  {
    all.push_back({ i, false, in - 0.5 * pi, out + 0.5 * pi });
  }
}
}
