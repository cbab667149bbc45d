// SPDX-License-Identifier: BSD-3-Clause
// Connectors against a search that starts anew for each.
#include "Base/CompressedRows.h"
#include "TestMeshes.h"
#include "Wires/WireNetwork.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Per vertex the vertex that stands for all that hang together by wires.
Indices components(const TriangleMesh& mesh, const std::vector<char>& isWire)
{
  JoinedSets joined(mesh.vertexCount());
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (isWire[h])
    {
      joined.join(mesh.from(h), mesh.to(h));
    }
  }
  Indices of;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    of.push_back(joined.find(v));
  }
  return of;
}

void markEdge(const TriangleMesh& mesh, Index h, std::vector<char>& isWire)
{
  isWire[h] = 1;
  if (mesh.twin(h) != none)
  {
    isWire[mesh.twin(h)] = 1;
  }
}

/// The boundary marked as wires. \param root one of its vertices
std::vector<char> boundaryWires(const TriangleMesh& mesh, Index& root)
{
  std::vector<char> isWire(mesh.halfedgeCount(), 0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      isWire[h] = 1;
      root = mesh.from(h);
    }
  }
  return isWire;
}

/// Distance of each vertex from the wires of a component, by going over all edges until nothing
/// changes.
std::vector<double> distances(
  const TriangleMesh& mesh, const Indices& of, const std::vector<char>& onWire, Index component)
{
  std::vector<double> distance(mesh.vertexCount(), HUGE_VAL);
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    distance[v] = onWire[v] && of[v] == component ? 0.0 : HUGE_VAL;
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (Index h = 0; h < mesh.halfedgeCount(); ++h)
    {
      for (const auto& [a, b] :
        { std::pair(mesh.from(h), mesh.to(h)), std::pair(mesh.to(h), mesh.from(h)) })
      {
        const bool passes = !onWire[a] || distance[a] == 0.0;
        if (passes && distance[a] + mesh.length(h) < distance[b])
        {
          distance[b] = distance[a] + mesh.length(h);
          changed = true;
        }
      }
    }
  }
  return distance;
}

/// Adds connectors as found, and checks that each is a shortest path to the nearest of the wires
/// that are not joined yet.
void expectShortestOneByOne(const TriangleMesh& mesh, std::vector<char> isWire, Index root)
{
  const Indices found = findConnectors(mesh, isWire, root);
  std::size_t used = 0;
  while (true)
  {
    const Indices of = components(mesh, isWire);
    std::vector<char> onWire(mesh.vertexCount(), 0);
    for (Index h = 0; h < mesh.halfedgeCount(); ++h)
    {
      onWire[mesh.from(h)] |= isWire[h];
      onWire[mesh.to(h)] |= isWire[h];
    }
    const std::vector<double> distance = distances(mesh, of, onWire, of[root]);
    double nearest = HUGE_VAL;
    for (Index v = 0; v < mesh.vertexCount(); ++v)
    {
      nearest = onWire[v] && of[v] != of[root] ? std::min(nearest, distance[v]) : nearest;
    }
    if (nearest == HUGE_VAL)
    {
      break;
    }
    // The path comes from its end to the joined wires.
    double length = 0.0;
    Index at = none;
    const std::size_t first = used;
    while (used < found.size() && (used == first || distance[at] > 0.0))
    {
      const Index h = found[used];
      if (used == first)
      {
        at = onWire[mesh.from(h)] && of[mesh.from(h)] != of[root] ? mesh.from(h) : mesh.to(h);
        EXPECT_NEAR(distance[at], nearest, 1e-12);
      }
      ASSERT_TRUE(mesh.from(h) == at || mesh.to(h) == at) << "a path hangs together";
      at = mesh.from(h) == at ? mesh.to(h) : mesh.from(h);
      length += mesh.length(h);
      markEdge(mesh, h, isWire);
      ++used;
    }
    ASSERT_GT(used, first) << "wires are left apart";
    EXPECT_NEAR(length, nearest, 1e-12);
  }
  EXPECT_EQ(used, found.size());
}
}

TEST(WireConnectors, JoinTheNearestOfTheOtherWiresByAShortestPathOneAfterTheOther)
{
  std::mt19937 random(5);
  for (const double height : { 0.0, 0.6 }) // flat: many paths are equally long
  {
    for (const int count : { 1, 2, 7, 25 })
    {
      const TriangleMesh mesh = cushion(14, 12, height).mesh;
      Index root = none;
      std::vector<char> isWire = boundaryWires(mesh, root);
      for (int k = 0; k < count; ++k)
      {
        markEdge(mesh, static_cast<Index>(random() % mesh.halfedgeCount()), isWire);
      }
      SCOPED_TRACE(std::to_string(count) + " loose edges, height " + std::to_string(height));
      expectShortestOneByOne(mesh, isWire, root);
    }
  }
}

TEST(WireConnectors, CostLittleMoreForMoreHoles)
{
  // Processor time for loose triangles six edges apart, 81 and 1,521 of them: a search that starts
  // anew for each takes 600 times as long, the mesh alone is 16 times as large.
  const auto seconds = [](Index size) {
    const TriangleMesh mesh = cushion(size, size, 0.3).mesh;
    Index root = none;
    std::vector<char> isWire = boundaryWires(mesh, root);
    for (Index j = 3; j < size - 3; j += 6)
    {
      for (Index i = 3; i < size - 3; i += 6)
      {
        const Index h = mesh.outgoing(j * (size + 1) + i);
        for (Index side = 3 * (h / 3); side < 3 * (h / 3) + 3; ++side)
        {
          markEdge(mesh, side, isWire);
        }
      }
    }
    const std::clock_t start = std::clock();
    EXPECT_FALSE(findConnectors(mesh, isWire, root).empty());
    return static_cast<double>(std::clock() - start);
  };
  const double few = std::max({ seconds(60), seconds(60), seconds(60) });
  EXPECT_LT(seconds(240), 200.0 * few);
}
