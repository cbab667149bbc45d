// SPDX-License-Identifier: BSD-3-Clause
// Replaces FabricLay.cxx, NoFitRegion.cxx and SeamAllowance.cxx in a build without Clipper.
#include "Drawing/SeamAllowance.h"
#include "Nesting/FabricLay.h"

namespace flattening::pattern
{
Status layOnFabric(const FabricOptions&, Pattern&)
{
  return { StatusCode::InvalidOption,
    "this build cannot lay pieces on cloth, because it was made without Clipper" };
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
