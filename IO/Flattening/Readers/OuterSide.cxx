// SPDX-License-Identifier: BSD-3-Clause
#include "OuterSide.h"

#include "Surface/SheetSides.h"
#include "Surface/SurfaceHealing.h"

#include <cstddef>
#include <vector>

namespace wirewarp
{
std::optional<double> takeOuterSide(TriangleList& list, bool clear)
{
  using flattening::Index;
  flattening::Triangles corners;
  for (const ListedTriangle& triangle : list.triangles)
  {
    const auto& [a, b, c] = triangle.corners;
    corners.push_back({ static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c) });
  }
  const flattening::HealedSurface healed = flattening::healSurface(
    *list.points, corners, flattening::CoincidentPoints::Automatic, flattening::Defects::Separate);
  std::vector<char> kept(list.triangles.size(), 1);
  const auto keep = [&](const flattening::Indices& triangles, char value) {
    for (Index t : triangles)
    {
      kept[healed.originalTriangle.empty() ? t : healed.originalTriangle[t]] = value;
    }
  };
  double thickness = 0.0;
  double count = 0.0;
  for (const flattening::ThickSheet& sheet : flattening::thickSheets(healed.mesh))
  {
    if (sheet.isClear || !clear)
    {
      keep(sheet.triangles, 0);
      keep(sheet.outer, 1);
      thickness += sheet.thickness * static_cast<double>(sheet.outer.size());
      count += static_cast<double>(sheet.outer.size());
    }
  }
  if (count == 0.0)
  {
    return {};
  }
  std::vector<ListedTriangle> outer;
  for (std::size_t t = 0; t < kept.size(); ++t)
  {
    if (kept[t])
    {
      outer.push_back(list.triangles[t]);
    }
  }
  list.triangles = std::move(outer);
  return thickness / count;
}
}
