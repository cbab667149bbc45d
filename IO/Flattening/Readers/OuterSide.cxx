// SPDX-License-Identifier: BSD-3-Clause
#include "OuterSide.h"

#include "Base/CompressedRows.h"
#include "Surface/SheetSides.h"
#include "Surface/SurfaceHealing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace wirewarp
{
namespace
{
using flattening::Index;
using Corners = std::array<std::int64_t, 3>;

Corners sorted(Corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

void keepOnly(TriangleList& list, const std::vector<char>& kept)
{
  std::vector<ListedTriangle> left;
  for (std::size_t t = 0; t < kept.size(); ++t)
  {
    if (kept[t])
    {
      left.push_back(list.triangles[t]);
    }
  }
  list.triangles = std::move(left);
}
}

std::size_t takeOneOfTwoFaces(TriangleList& list)
{
  flattening::JoinedSets parts(static_cast<Index>(list.points->size()));
  std::map<std::array<double, 3>, std::int64_t> firstAt; // point, by its place
  const auto place = [&](std::int64_t p) {
    const Point3& x = list.point(p);
    return firstAt.emplace(std::array{ x[0], x[1], x[2] }, p).first->second;
  };
  std::map<Corners, std::vector<std::size_t>> triangles; // by the places of their corners
  for (std::size_t t = 0; t < list.triangles.size(); ++t)
  {
    const auto& [a, b, c] = list.triangles[t].corners;
    parts.join(static_cast<Index>(a), static_cast<Index>(b));
    parts.join(static_cast<Index>(b), static_cast<Index>(c));
    triangles[sorted({ place(a), place(b), place(c) })].push_back(t);
  }
  std::vector<char> kept(list.triangles.size(), 1);
  for (auto& [corners, same] : triangles)
  {
    const auto part = [&](std::size_t t) {
      return parts.find(static_cast<Index>(list.triangles[t].corners[0]));
    };
    const auto stays = std::min_element(
      same.begin(), same.end(), [&](std::size_t t, std::size_t u) { return part(t) < part(u); });
    const Corners first = sorted(list.triangles[*stays].corners);
    for (const std::size_t t : same)
    {
      kept[t] = sorted(list.triangles[t].corners) == first ? 1 : 0; // such are healed later
    }
  }
  const auto left = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), char{ 0 }));
  if (left > 0)
  {
    keepOnly(list, kept);
  }
  return left;
}

std::optional<double> takeOuterSide(TriangleList& list, bool clear)
{
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
  // What healing took out as the double of an inner one goes with it.
  std::set<Corners> inner;
  for (std::size_t t = 0; t < kept.size(); ++t)
  {
    if (!kept[t])
    {
      inner.insert(sorted(list.triangles[t].corners));
    }
  }
  for (std::size_t t = 0; t < kept.size(); ++t)
  {
    kept[t] = kept[t] && inner.count(sorted(list.triangles[t].corners)) == 0 ? 1 : 0;
  }
  keepOnly(list, kept);
  return thickness / count;
}
}
