// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/TriangleOrientation.h"

#include "Surface/EdgeSides.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// Turns triangles over until neighbours agree. Returns the triangles of a one-sided band, if any.
/// \param partner of each half-edge, before that.
Indices turnOver(Triangles& triangles, const Indices& partner, Indices& reversed)
{
  const Index count = static_cast<Index>(triangles.size());
  auto start = [&triangles](Index h) { return triangles[h / 3][h % 3]; };
  std::vector<signed char> turn(count, -1); // 0: keep, 1: turn over
  Indices stack;
  for (Index seed = 0; seed < count; ++seed)
  {
    if (turn[seed] != -1)
    {
      continue;
    }
    Indices component;
    turn[seed] = 0;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const Index t = stack.back();
      stack.pop_back();
      component.push_back(t);
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index other = partner[h];
        if (other == none)
        {
          continue;
        }
        // Consistent neighbours run along their common edge in opposite directions.
        const signed char wanted = start(h) == start(other) ? 1 - turn[t] : turn[t];
        if (turn[other / 3] == -1)
        {
          turn[other / 3] = wanted;
          stack.push_back(other / 3);
        }
        else if (turn[other / 3] != wanted)
        {
          return { std::min(t, other / 3), std::max(t, other / 3) };
        }
      }
    }
    const auto turned =
      std::count_if(component.begin(), component.end(), [&turn](Index t) { return turn[t] == 1; });
    const signed char minority = 2 * turned > static_cast<std::ptrdiff_t>(component.size()) ? 0 : 1;
    for (Index t : component)
    {
      if (turn[t] == minority)
      {
        std::swap(triangles[t][1], triangles[t][2]);
        reversed.push_back(t);
      }
    }
  }
  std::sort(reversed.begin(), reversed.end());
  return {};
}

/// Triangles that have the same corners as an earlier one, in either orientation: they share edges,
/// and the corner opposite to each.
Indices findDoubled(const Triangles& triangles, const std::vector<EdgeSide>& sides)
{
  Indices doubled;
  std::vector<std::pair<Index, Index>> around; // corner opposite to an edge, triangle
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const EdgeSide& side = sides[i];
    const bool first = i == 0 || sides[i - 1].low != side.low || sides[i - 1].high != side.high;
    if (first)
    {
      around.clear();
    }
    const Index t = side.halfedge / 3;
    around.emplace_back(triangles[t][(side.halfedge + 2) % 3], t);
    const bool last =
      i + 1 == sides.size() || sides[i + 1].low != side.low || sides[i + 1].high != side.high;
    if (last && around.size() > 1)
    {
      std::sort(around.begin(), around.end());
      for (std::size_t k = 1; k < around.size(); ++k)
      {
        if (around[k].first == around[k - 1].first)
        {
          doubled.push_back(around[k].second);
        }
      }
    }
  }
  std::sort(doubled.begin(), doubled.end());
  doubled.erase(std::unique(doubled.begin(), doubled.end()), doubled.end());
  return doubled;
}
}

Status orientTriangles(
  const Indices& pointIds, Triangles& triangles, Indices& partner, Indices& reversed)
{
  const std::vector<EdgeSide> sides = sortedSides(triangles, pointIds.size());
  Indices bad = findDoubled(triangles, sides);
  if (!bad.empty())
  {
    return { StatusCode::NonManifoldEdge,
      "triangles " + listIds(bad) + " have the same three corners as another",
      { ElementKind::Cells, bad }, { Remedy::RemoveDoubles, Remedy::SeparateSides } };
  }
  for (std::size_t i = 0; i + 2 < sides.size(); ++i)
  {
    if (sides[i].low == sides[i + 2].low && sides[i].high == sides[i + 2].high)
    {
      for (std::size_t k = i;
           k < sides.size() && sides[k].low == sides[i].low && sides[k].high == sides[i].high; ++k)
      {
        bad.push_back(sides[k].halfedge / 3);
      }
      return { StatusCode::NonManifoldEdge,
        "the edge between points " + std::to_string(pointIds[sides[i].low]) + " and " +
          std::to_string(pointIds[sides[i].high]) + " belongs to triangles " + listIds(bad) +
          " (an edge can join two at most)",
        { ElementKind::Cells, bad }, { Remedy::RemoveDoubles, Remedy::SeparateSheets } };
    }
  }
  partner = pairSides(sides);
  const Indices oneSided = turnOver(triangles, partner, reversed);
  if (!oneSided.empty())
  {
    return { StatusCode::NotOrientable,
      "the surface is one-sided (a Moebius band): triangles " + listIds(oneSided) +
        " cannot be oriented alike",
      { ElementKind::Cells, oneSided }, { Remedy::CutBandThrough } };
  }
  return {};
}
}
