// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/HalfedgeKey.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
std::vector<HalfedgeKey> sortedSides(const Triangles& triangles, std::size_t vertexCount)
{
  const auto side = [&triangles](std::size_t h) -> HalfedgeKey {
    const Index a = triangles[h / 3][h % 3];
    const Index b = triangles[h / 3][(h + 1) % 3];
    return { std::min(a, b), std::max(a, b), static_cast<Index>(h) };
  };
  const std::size_t count = 3 * triangles.size();
  Indices begin(vertexCount + 1, 0);
  for (std::size_t h = 0; h < count; ++h)
  {
    ++begin[side(h).low + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Indices place(begin.begin(), begin.end() - 1);
  std::vector<HalfedgeKey> sides(count);
  for (std::size_t h = 0; h < count; ++h)
  {
    const HalfedgeKey s = side(h);
    sides[place[s.low]++] = s;
  }
  for (std::size_t v = 0; v < vertexCount; ++v)
  {
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1],
      [](const HalfedgeKey& a, const HalfedgeKey& b) {
        return a.high != b.high ? a.high < b.high : a.halfedge < b.halfedge;
      });
  }
  return sides;
}

Indices pairSides(const std::vector<HalfedgeKey>& sides)
{
  Indices partner(sides.size(), none);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    if (sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high)
    {
      partner[sides[i].halfedge] = sides[i + 1].halfedge;
      partner[sides[i + 1].halfedge] = sides[i].halfedge;
    }
  }
  return partner;
}

std::vector<Indices> crowdedEdges(const std::vector<HalfedgeKey>& sides)
{
  std::vector<Indices> crowded;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end)
  {
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
    {
      ++end;
    }
    if (end - i > 2)
    {
      crowded.emplace_back();
      for (std::size_t k = i; k < end; ++k)
      {
        crowded.back().push_back(sides[k].halfedge);
      }
    }
  }
  return crowded;
}

Indices pairOrientedSides(const Triangles& triangles, std::size_t vertexCount)
{
  // Sides that leave or reach a vertex from one with a greater id, as a list a vertex.
  constexpr int longestList = 64;
  const Index count = 3 * static_cast<Index>(triangles.size());
  Indices first(vertexCount, none);
  Indices following(count, none);
  Indices high(count, none);
  Indices partner(count, none);
  for (Index h = 0; h < count; ++h)
  {
    const Triangle& corner = triangles[h / 3];
    const Index from = corner[h % 3];
    const Index to = corner[(h + 1) % 3];
    const Index low = std::min(from, to);
    high[h] = std::max(from, to);
    Index other = first[low];
    for (int steps = 0; other != none && high[other] != high[h]; other = following[other])
    {
      if (++steps > longestList)
      {
        return {};
      }
    }
    if (other == none)
    {
      following[h] = first[low];
      first[low] = h;
      continue;
    }
    const Triangle& opposite = triangles[other / 3];
    if (partner[other] != none || opposite[other % 3] == from ||
      opposite[(other + 2) % 3] == corner[(h + 2) % 3])
    {
      return {};
    }
    partner[h] = other;
    partner[other] = h;
  }
  return partner;
}
}
