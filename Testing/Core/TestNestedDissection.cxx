// SPDX-License-Identifier: BSD-3-Clause
#include "Base/CompressedRows.h"
#include "Sparse/NestedDissection.h"
#include "TestGraphs.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

using namespace flattening;
using namespace testmeshes;

namespace
{
void expectOrderInRanges(const Dissection& dissection, Index count)
{
  Indices sorted = dissection.order;
  std::sort(sorted.begin(), sorted.end());
  Indices all(count);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all) << "each vertex once";
  ASSERT_FALSE(dissection.end.empty());
  EXPECT_TRUE(std::is_sorted(dissection.end.begin(), dissection.end.end()));
  EXPECT_EQ(std::adjacent_find(dissection.end.begin(), dissection.end.end()), dissection.end.end());
  EXPECT_EQ(dissection.end.back(), count);
}
}

TEST(NestedDissection, PutsASmallSeparatorThatDividesTheMeshLast)
{
  const Surface surface = flatPatch(40, 30);
  const Triangles& triangles = surface.mesh.triangles();
  const Index count = surface.mesh.vertexCount();
  for (const Dissection& dissection :
    { dissect(triangles, surface.mesh.points()), dissect(triangles, count) })
  {
    expectOrderInRanges(dissection, count);
    const Index begin = dissection.end[dissection.end.size() - 2];
    EXPECT_LT(count - begin, 100) << "of 1271 vertices";
    // Without it no part that hangs together has many more than half of the others.
    std::vector<char> separates(count, 0);
    for (Index k = begin; k < count; ++k)
    {
      separates[dissection.order[k]] = 1;
    }
    JoinedSets parts(count);
    for (const Triangle& t : triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (!separates[t[k]] && !separates[t[(k + 1) % 3]])
        {
          parts.join(t[k], t[(k + 1) % 3]);
        }
      }
    }
    Indices size(count, 0);
    for (Index v = 0; v < count; ++v)
    {
      size[parts.find(v)] += separates[v] ? 0 : 1;
    }
    EXPECT_LT(*std::max_element(size.begin(), size.end()), 0.65 * count);
  }
}

TEST(NestedDissection, EndsWithEachVertexOnceForGraphsOfEveryShape)
{
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  const std::vector<testgraphs::Graph> graphs = testgraphs::graphs();
  ASSERT_GT(graphs.size(), 50U);
  for (const testgraphs::Graph& graph : graphs)
  {
    SCOPED_TRACE(graph.name);
    expectOrderInRanges(dissect(graph.cliques, graph.count), graph.count);
    Points3 positions(graph.count);
    std::generate(positions.begin(), positions.end(),
      [&] { return Point3(place(generator), place(generator), 0.0); });
    expectOrderInRanges(dissect(graph.cliques, positions), graph.count);
  }
}

TEST(NestedDissection, PutsTheHubOfAWideFanLastAndNoneOfItsRing)
{
  const testgraphs::Graph fan = testgraphs::dome(20000, 1);
  Points3 positions(fan.count, Point3::Zero());
  for (Index v = 1; v < fan.count; ++v)
  {
    const double angle = 2.0 * pi * v / (fan.count - 1);
    positions[v] = Point3(std::cos(angle), std::sin(angle), 0.0);
  }
  for (const Dissection& dissection :
    { dissect(fan.cliques, fan.count), dissect(fan.cliques, positions) })
  {
    EXPECT_EQ(dissection.order.back(), 0);
    Index begin = 0;
    for (Index end : dissection.end)
    {
      EXPECT_LE(end - begin, 12) << "a range of the ring as large as a part that is not divided";
      begin = end;
    }
  }
}

TEST(NestedDissection, CutsRingsOfLongTrianglesAcrossInsteadOfAlongAPlane)
{
  const testgraphs::Graph rings = testgraphs::dome(6000, 5);
  Points3 positions(rings.count, Point3::Zero());
  for (Index v = 1; v < rings.count; ++v)
  {
    const double angle = 2.0 * pi * ((v - 1) % 6000) / 6000;
    positions[v] = (1 + (v - 1) / 6000) * Point3(std::cos(angle), std::sin(angle), 0.0);
  }
  const Dissection dissection = dissect(rings.cliques, positions);
  Index begin = 0;
  for (Index end : dissection.end)
  {
    EXPECT_LT(end - begin, 100) << "a dense block of so many vertices";
    begin = end;
  }
}
