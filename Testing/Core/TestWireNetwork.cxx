// SPDX-License-Identifier: BSD-3-Clause
#include "WiredSurface.h"
#include "Wires/WireNetwork.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// What holds for every network: loops are closed chains, twins run back, and each wire edge has as
/// many sides as it has faces of the plane beside it.
void expectConsistent(const WireNetwork& network)
{
  ASSERT_TRUE(network.status.ok()) << network.status.message;
  for (Index side = 0; side < network.nodeCount(); ++side)
  {
    EXPECT_EQ(network.next[network.previous[side]], side);
    EXPECT_EQ(network.loop[network.next[side]], network.loop[side]);
    const WireEdge& edge = network.edges[network.edge[side]];
    EXPECT_TRUE(edge.side == side || edge.otherSide == side);
    const bool along = network.alongEdge(side);
    EXPECT_EQ(network.vertex[side], along ? edge.from : edge.to);
    EXPECT_EQ(network.endVertex(side), along ? edge.to : edge.from);
    const Index twin = network.twin[side];
    EXPECT_EQ(twin, along ? edge.otherSide : edge.side);
    if (twin != none)
    {
      EXPECT_EQ(network.twin[twin], side);
      EXPECT_EQ(network.vertex[twin], network.endVertex(side));
    }
  }
  // Nodes around each host vertex are all nodes, once.
  Index counted = 0;
  for (std::size_t host = 0; host < network.hostVertices.size(); ++host)
  {
    for (Index k = network.vertexNodeBegin[host]; k < network.vertexNodeBegin[host + 1]; ++k)
    {
      EXPECT_EQ(network.vertex[network.vertexNodes[k]], network.hostVertices[host]);
      ++counted;
    }
  }
  EXPECT_EQ(counted, network.nodeCount());
  // Faces of a connected plane graph with the outer one: Euler's formula.
  EXPECT_EQ(
    static_cast<Index>(network.hostVertices.size()) - network.edgeCount() + network.loopCount() + 1,
    2);
}

/// The angles of the triangles of a patch at a vertex.
double angleAt(const WiredSurface& wired, Index patch, Index vertex)
{
  double sum = 0.0;
  const TriangleMesh& mesh = wired.piece.mesh;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.from(h) == vertex && wired.network.patchOfTriangle[h / 3] == patch)
    {
      sum += mesh.angle(h);
    }
  }
  return sum;
}

Index at(Index n, Index i, Index j)
{
  return j * (n + 1) + i;
}

Index connectorCount(const WireNetwork& network)
{
  return static_cast<Index>(std::count_if(network.edges.begin(), network.edges.end(),
    [](const WireEdge& edge) { return edge.connector; }));
}
}

TEST(WireNetwork, AlphaSumsTheAnglesOfThePatchAtTheVertex)
{
  Surface surface = cushion(6, 6, 0.6);
  surface.curves = { rowCurve(6, 2), rowCurve(6, 4), columnCurve(6, 6, 3) };
  const WiredSurface wired(surface);
  expectConsistent(wired.network);
  EXPECT_EQ(wired.network.patchCount, 6);
  for (Index node = 0; node < wired.network.nodeCount(); ++node)
  {
    const Index patch = wired.network.patchOfLoop[wired.network.loop[node]];
    EXPECT_NEAR(
      wired.network.alpha[node], angleAt(wired, patch, wired.network.vertex[node]), 1e-13);
  }
}

TEST(WireNetwork, ADanglingWireHasBothItsSidesInOnePatchAndAWholeTurnAtItsTip)
{
  Surface surface = flatPatch(5, 5);
  surface.curves = { accessory("dangling", { at(5, 2, 0), at(5, 2, 1), at(5, 2, 2) }) };
  const WiredSurface wired(surface);
  expectConsistent(wired.network);
  EXPECT_EQ(wired.network.patchCount, 1);
  EXPECT_EQ(wired.network.nodeCount(), 20 + 4);
  EXPECT_EQ(connectorCount(wired.network), 0);
  const Indices tip = wired.nodes(at(5, 2, 2));
  ASSERT_EQ(tip.size(), 1U);
  EXPECT_NEAR(wired.network.alpha[tip.front()], 2.0 * pi, 1e-13);
  EXPECT_TRUE(wired.network.interior[wired.network.hostOfVertex[wired.vertex(at(5, 2, 2))]]);
}

TEST(WireNetwork, AClosedFloatingWireEnclosesAPatchOfItsOwn)
{
  Surface surface = cushion(6, 6, 0.4);
  surface.curves = { accessory("ring",
    { at(6, 2, 2), at(6, 3, 2), at(6, 4, 2), at(6, 4, 3), at(6, 4, 4), at(6, 3, 4), at(6, 2, 4),
      at(6, 2, 3), at(6, 2, 2) }) };
  const WiredSurface wired(surface);
  expectConsistent(wired.network);
  EXPECT_EQ(wired.network.patchCount, 2);
  EXPECT_EQ(connectorCount(wired.network), 2);
}

TEST(WireNetwork, TheLoopAroundAHoleIsAFaceWithoutTriangles)
{
  Surface surface = flatPatch(6, 6);
  surface.curves = { curveOf(CurveType::Dart, "eye", { at(6, 3, 2), at(6, 3, 3), at(6, 3, 4) }) };
  const WiredSurface wired(surface);
  expectConsistent(wired.network);
  EXPECT_EQ(wired.network.patchCount, 1);
  ASSERT_EQ(wired.network.loopCount(), 2);
  EXPECT_FALSE(wired.network.isHole(0));
  EXPECT_TRUE(wired.network.isHole(1));
  EXPECT_GT(connectorCount(wired.network), 0);
  // On a flat surface the slit's hole is a polygon of no area: angle 0 at its ends, pi between.
  double sum = 0.0;
  for (Index i = wired.network.loopBegin[1]; i < wired.network.loopBegin[2]; ++i)
  {
    sum += wired.network.alpha[i];
    EXPECT_TRUE(wired.network.interior[wired.network.hostOfVertex[wired.network.vertex[i]]]);
  }
  EXPECT_EQ(wired.network.loopBegin[2] - wired.network.loopBegin[1], 4);
  EXPECT_NEAR(sum, 2.0 * pi, 1e-12);
}

TEST(WireNetwork, TheOuterBoundaryIsTheOneThatTurnsAroundTheSurfaceHoweverLongOthersAre)
{
  // A zigzag slit, whose two banks are longer than the boundary of the flat sheet.
  Surface surface = flatPatch(8, 8);
  Indices zigzag;
  for (Index j = 1; j < 8; ++j)
  {
    for (Index i = 1; i < 8; ++i)
    {
      zigzag.push_back(at(8, j % 2 == 1 ? i : 8 - i, j));
    }
  }
  surface.curves = { curveOf(CurveType::Dart, "slit", zigzag) };
  const WiredSurface wired(surface);
  expectConsistent(wired.network);
  for (std::size_t host = 0; host < wired.network.hostVertices.size(); ++host)
  {
    const Index v = wired.original(wired.network.hostVertices[host]);
    const Index i = v % 9;
    const Index j = v / 9;
    const bool outside = i == 0 || j == 0 || i == 8 || j == 8;
    EXPECT_EQ(wired.network.interior[host] == 0, outside) << "vertex " << v;
  }
}

TEST(WireNetwork, OfAPieceThatIsKnownToBeSoundIsTheSame)
{
  Surface surface = cushion(8, 8, 0.5);
  surface.curves = { rowCurve(8, 6), curveOf(CurveType::Dart, "eye", { 22, 31, 40 }) };
  const WiredSurface wired(surface);
  const WireNetwork known = buildWireNetwork(wired.piece, true);
  EXPECT_TRUE(known.status.ok());
  EXPECT_EQ(known.vertex, wired.network.vertex);
  EXPECT_EQ(known.next, wired.network.next);
  EXPECT_EQ(known.alpha, wired.network.alpha);
  EXPECT_EQ(known.boundaryLoops, 2) << "the outer one, and that of the dart inside";
}

TEST(WireNetwork, AWireThroughTheWholePieceThatTouchesItselfStaysConsistent)
{
  // A figure of eight: two patches meet in the vertex where it crosses itself.
  Surface surface = cushion(8, 8, 0.4);
  surface.curves = { accessory("eight",
    { at(8, 4, 4), at(8, 5, 4), at(8, 6, 4), at(8, 6, 5), at(8, 6, 6), at(8, 5, 6), at(8, 4, 6),
      at(8, 4, 5), at(8, 4, 4), at(8, 4, 3), at(8, 4, 2), at(8, 3, 2), at(8, 2, 2), at(8, 2, 3),
      at(8, 2, 4), at(8, 3, 4), at(8, 4, 4) }) };
  const WiredSurface wired(surface);
  expectConsistent(wired.network);
  EXPECT_EQ(wired.network.patchCount, 3);
}
