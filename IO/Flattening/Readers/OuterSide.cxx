// SPDX-License-Identifier: BSD-3-Clause
#include "OuterSide.h"

#include "BoundaryLoops.h"

#include "Base/CompressedRows.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace wirewarp
{
namespace
{
using flattening::Index;

/// Degrees between triangles at the rim of a sheet; that of a square one has 90.
constexpr double rimAngle = 60.0;

Point3 twiceArea(const TriangleList& list, const ListedTriangle& triangle)
{
  const Point3& a = list.point(triangle.corners[0]);
  return (list.point(triangle.corners[1]) - a).cross(list.point(triangle.corners[2]) - a);
}

/// Per member the number of its set.
flattening::Indices numbersOf(flattening::JoinedSets& sets, std::size_t count)
{
  flattening::Indices numbers(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    numbers[k] = sets.find(static_cast<Index>(k));
  }
  return numbers;
}

/// Per triangle its part, of those that hang together by points.
flattening::Indices partsOf(const TriangleList& list)
{
  flattening::JoinedSets parts(static_cast<Index>(list.triangles.size()));
  std::map<std::int64_t, Index> firstAt;
  for (Index t = 0; t < static_cast<Index>(list.triangles.size()); ++t)
  {
    for (const std::int64_t corner : list.triangles[t].corners)
    {
      parts.join(firstAt.emplace(corner, t).first->second, t);
    }
  }
  return numbersOf(parts, list.triangles.size());
}

/// Per triangle its side, of those that hang together by edges that are not sharp.
flattening::Indices sidesOf(const TriangleList& list)
{
  struct Use
  {
    Index triangle;
    bool forwards;
  };
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Use>> edges;
  for (std::size_t t = 0; t < list.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t a = list.triangles[t].corners[k];
      const std::int64_t b = list.triangles[t].corners[(k + 1) % 3];
      edges[std::minmax(a, b)].push_back({ static_cast<Index>(t), a < b });
    }
  }
  flattening::JoinedSets sides(static_cast<Index>(list.triangles.size()));
  for (const auto& [edge, uses] : edges)
  {
    if (uses.size() != 2)
    {
      continue;
    }
    const Point3 a = twiceArea(list, list.triangles[uses[0].triangle]);
    const Point3 b = twiceArea(list, list.triangles[uses[1].triangle]);
    // Triangles may be turned over against each other.
    const double turned = uses[0].forwards == uses[1].forwards ? -1.0 : 1.0;
    if (turned * a.dot(b) > std::cos(rimAngle * flattening::degree) * a.norm() * b.norm())
    {
      sides.join(uses[0].triangle, uses[1].triangle);
    }
  }
  return numbersOf(sides, list.triangles.size());
}
}

std::string takeOuterSide(TriangleList& list)
{
  const std::size_t count = list.triangles.size();
  const flattening::Indices part = partsOf(list);
  const flattening::Indices side = sidesOf(list);

  std::set<Index> open;
  std::map<std::int64_t, Index> partOfPolygon;
  for (std::size_t t = 0; t < count; ++t)
  {
    partOfPolygon[list.triangles[t].polygon] = part[t];
  }
  for (const BoundaryLoop& loop : boundaryLoops(list))
  {
    open.insert(partOfPolygon[loop.polygon]);
  }
  std::map<Index, std::map<Index, double>> areas; // by part, by side
  for (std::size_t t = 0; t < count; ++t)
  {
    areas[part[t]][side[t]] += twiceArea(list, list.triangles[t]).norm();
  }
  std::map<Index, Index> outer;
  for (const auto& [region, sides] : areas)
  {
    for (const auto& [candidate, area] : sides)
    {
      if (sides.size() > 1 && open.count(region) == 0 &&
        (outer.count(region) == 0 || area > sides.at(outer[region])))
      {
        outer[region] = candidate;
      }
    }
  }
  if (outer.empty())
  {
    return "--outer-side found no closed sheet with a sharp rim";
  }
  std::vector<ListedTriangle> kept;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (outer.count(part[t]) == 0 || outer[part[t]] == side[t])
    {
      kept.push_back(list.triangles[t]);
    }
  }
  list.triangles = std::move(kept);
  return "of " + std::to_string(count) + " triangles the " + std::to_string(list.triangles.size()) +
    " of the outer side are kept, as --outer-side asks";
}
}
