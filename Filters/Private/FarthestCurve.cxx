// SPDX-License-Identifier: BSD-3-Clause
#include "FarthestCurve.h"

#include "Imprint/ImprintedSurface.h"

namespace flattening
{
namespace bridge
{
FarthestCurve::FarthestCurve(const DrawingSurface& surface)
  : Surface(surface)
{
}

void FarthestCurve::offer(const Polyline& line)
{
  for (const Point3& point : line.points)
  {
    const double distance = this->Surface.locator().closest(point).distance;
    if (distance > this->Distance)
    {
      this->Distance = distance;
      this->Name = line.name;
    }
  }
}

std::string FarthestCurve::note() const
{
  Eigen::AlignedBox3d box;
  for (const Point3& point : this->Surface.mesh().points())
  {
    box.extend(point);
  }
  return this->Distance > ImprintOptions().tolerance * box.diagonal().norm()
    ? "the curve \"" + this->Name + "\" was up to " + shortNumber(this->Distance) +
      " from the surface and is laid onto it; was it drawn on another one, or in another unit?"
    : "";
}
}
}
