// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/NearbyLegs.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Boxes are wider than the bound by this fraction, so that rounding leaves no leg out.
constexpr double margin = 1e-6;
}

NearbyLegs::NearbyLegs(const SurfacePath& path, double bound)
  : Path(path)
{
  const double reach = (1.0 + margin) * bound;
  this->Size = 2.0 * reach;
  for (std::size_t leg = 0; leg < path.triangles.size(); ++leg)
  {
    this->Size =
      std::max(this->Size, (path.points[leg + 1].position - path.points[leg].position).norm());
  }
  for (std::size_t leg = 0; leg < path.triangles.size(); ++leg)
  {
    const Point3& a = path.points[leg].position;
    const Point3& b = path.points[leg + 1].position;
    const Cell low = this->cellOf(a.cwiseMin(b) - Point3::Constant(reach));
    const Cell high = this->cellOf(a.cwiseMax(b) + Point3::Constant(reach));
    for (Cell cell = low; cell[0] <= high[0]; ++cell[0])
    {
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
      {
        for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
        {
          this->Legs[cell].push_back(leg);
        }
      }
    }
  }
}

NearbyLegs::Cell NearbyLegs::cellOf(const Point3& point) const
{
  const Point3& origin = this->Path.points.front().position;
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis)
  {
    cell[static_cast<std::size_t>(axis)] =
      static_cast<std::int64_t>(std::floor((point[axis] - origin[axis]) / this->Size));
  }
  return cell;
}

std::vector<PathFoot> NearbyLegs::feet(const Point3& point, double bound) const
{
  std::vector<PathFoot> feet;
  const auto near = this->Legs.find(this->cellOf(point));
  if (near == this->Legs.end())
  {
    return feet;
  }
  const std::size_t count = this->Path.triangles.size();
  for (const std::size_t leg : near->second)
  {
    const PathFoot foot = footOnLeg(this->Path, leg, point);
    if (foot.gap < bound && (leg == 0 || foot.gap < footOnLeg(this->Path, leg - 1, point).gap) &&
      (leg + 1 == count || foot.gap <= footOnLeg(this->Path, leg + 1, point).gap))
    {
      feet.push_back(foot);
    }
  }
  return feet;
}
}
