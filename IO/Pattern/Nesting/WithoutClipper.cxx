// SPDX-License-Identifier: BSD-3-Clause
// In the place of NoFitRegion.cxx and SeamAllowance.cxx in a build without Clipper.
#include "Drawing/SeamAllowance.h"
#include "Nesting/NoFitRegion.h"

namespace flattening::pattern
{
struct NoFitRegion::Shapes
{
};

NoFitRegion::NoFitRegion() = default;
NoFitRegion::~NoFitRegion() = default;

bool NoFitRegion::available()
{
  return false;
}

std::size_t NoFitRegion::addShape(const Points2&, double)
{
  return 0;
}

Point2 NoFitRegion::lowest(const std::vector<Placed>&, std::size_t, double) const
{
  return Point2::Zero();
}

Status addAllowance(
  const std::vector<AllowancePolygon>& polygons, double, std::vector<Points2>& widened)
{
  widened.clear();
  if (hasAllowance(polygons))
  {
    return { StatusCode::InvalidOption,
      "this build cannot add a seam allowance, because it was made without Clipper", {},
      { { Remedy::Give, "an allowance of 0" } } };
  }
  for (const AllowancePolygon& polygon : polygons)
  {
    widened.push_back(polygon.points);
  }
  return {};
}
}
