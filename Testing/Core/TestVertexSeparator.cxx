// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NestedDissection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

using namespace flattening;

namespace
{
using Side = VertexSeparator::Side;

struct FlatGraph
{
  Indices begin;
  Indices neighbours;

  FlatGraph(Index count, const std::vector<std::pair<Index, Index>>& edges)
    : begin(1, 0)
  {
    for (Index v = 0; v < count; ++v)
    {
      for (const auto& [a, b] : edges)
      {
        if (a == v || b == v)
        {
          this->neighbours.push_back(a == v ? b : a);
        }
      }
      this->begin.push_back(static_cast<Index>(this->neighbours.size()));
    }
  }

  /// Whether a way leads from the left to the right without the vertices that are taken out.
  bool leadsAcross(const std::vector<Side>& sides, const std::vector<char>& taken) const
  {
    Indices queue;
    std::vector<char> seen(sides.size(), 0);
    const auto visit = [&](Index v) {
      if (!seen[v] && !taken[v])
      {
        seen[v] = 1;
        queue.push_back(v);
      }
    };
    for (Index v = 0; v < static_cast<Index>(sides.size()); ++v)
    {
      if (sides[v] == Side::Left)
      {
        visit(v);
      }
    }
    for (std::size_t at = 0; at < queue.size(); ++at)
    {
      if (sides[queue[at]] == Side::Right)
      {
        return true;
      }
      std::for_each(this->neighbours.begin() + this->begin[queue[at]],
        this->neighbours.begin() + this->begin[queue[at] + 1], visit);
    }
    return false;
  }
};

Indices between(const std::vector<Side>& sides)
{
  Indices result;
  for (std::size_t v = 0; v < sides.size(); ++v)
  {
    if (sides[v] == Side::Between)
    {
      result.push_back(static_cast<Index>(v));
    }
  }
  return result;
}

/// The fewest of all sets of vertices between, one by one.
Index fewest(const FlatGraph& graph, const std::vector<Side>& sides)
{
  const Indices vertices = between(sides);
  auto best = static_cast<Index>(vertices.size());
  for (unsigned set = 0; set < (1U << vertices.size()); ++set)
  {
    std::vector<char> taken(sides.size(), 0);
    Index count = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      taken[vertices[k]] = (set >> k) & 1U;
      count += taken[vertices[k]];
    }
    if (count < best && !graph.leadsAcross(sides, taken))
    {
      best = count;
    }
  }
  return best;
}
}

TEST(VertexSeparator, IsAsSmallAsTheSmallestOfAllSetsOfRandomGraphs)
{
  std::mt19937 random(7);
  int larger = 0;
  for (int seed = 0; seed < 300; ++seed)
  {
    const Index count = 14;
    std::vector<Side> sides(count, Side::Between);
    sides[0] = sides[1] = Side::Left;
    sides[2] = sides[3] = Side::Right;
    std::vector<std::pair<Index, Index>> edges;
    const unsigned density = 2 + seed % 4;
    for (Index a = 0; a < count; ++a)
    {
      for (Index b = 0; b < a; ++b)
      {
        const bool across = sides[a] == Side::Right && sides[b] == Side::Left;
        if (!across && random() % 10 < density)
        {
          edges.emplace_back(a, b);
        }
      }
    }
    const FlatGraph graph(count, edges);
    VertexSeparator separator(graph.begin, graph.neighbours);
    for (Index v = 0; v < count; ++v)
    {
      separator.setSide(v, sides[v]);
    }
    const Index expected = fewest(graph, sides);
    ASSERT_TRUE(separator.separate(between(sides), expected)) << "seed " << seed;
    std::vector<char> taken(count, 0);
    Index found = 0;
    for (Index v = 0; v < count; ++v)
    {
      taken[v] = separator.side(v) == Side::Between ? 1 : 0;
      found += taken[v];
      if (sides[v] != Side::Between)
      {
        EXPECT_EQ(separator.side(v), sides[v]);
      }
    }
    EXPECT_EQ(found, expected) << "seed " << seed;
    EXPECT_FALSE(graph.leadsAcross(sides, taken)) << "seed " << seed;
    for (const auto& [a, b] : edges)
    {
      EXPECT_FALSE((separator.side(a) == Side::Left && separator.side(b) == Side::Right) ||
        (separator.side(a) == Side::Right && separator.side(b) == Side::Left))
        << "seed " << seed << ": an edge from side to side";
    }
    larger += expected > 3 ? 1 : 0;
  }
  EXPECT_GT(larger, 50) << "cases that take more than one way";
}

TEST(VertexSeparator, SaysWhereItTakesMoreVerticesThanAllowed)
{
  // Left 0, right 1, and five ways between them.
  std::vector<std::pair<Index, Index>> edges;
  Indices middle;
  for (Index v = 2; v < 7; ++v)
  {
    edges.emplace_back(0, v);
    edges.emplace_back(v, 1);
    middle.push_back(v);
  }
  const FlatGraph graph(7, edges);
  for (const Index most : { 3, 4, 5, 6 })
  {
    VertexSeparator separator(graph.begin, graph.neighbours);
    separator.setSide(0, Side::Left);
    separator.setSide(1, Side::Right);
    for (Index v : middle)
    {
      separator.setSide(v, Side::Between);
    }
    EXPECT_EQ(separator.separate(middle, most), most >= 5);
  }
}
