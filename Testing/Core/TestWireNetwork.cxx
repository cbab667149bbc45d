// SPDX-License-Identifier: BSD-3-Clause
#include "Base/CompressedRows.h"
#include "WiredSurface.h"
#include "Wires/WireNetwork.h"

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

Index connectorCount(const WireNetwork& network)
{
  return static_cast<Index>(std::count_if(network.edges.begin(), network.edges.end(),
    [](const WireEdge& edge) { return edge.connector; }));
}
}

TEST(WireNetwork, AlphaSumsTheAnglesOfThePatchAtTheVertex)
{
  const WiredSurface wired(
    withCurves(cushion(6, 6, 0.6), { rowCurve(6, 2), rowCurve(6, 4), columnCurve(6, 6, 3) }));
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
  const WiredSurface wired(withCurves(
    flatPatch(5, 5), { accessory("dangling", { at(5, 2, 0), at(5, 2, 1), at(5, 2, 2) }) }));
  expectConsistent(wired.network);
  EXPECT_EQ(wired.network.patchCount, 1);
  EXPECT_EQ(wired.network.nodeCount(), 20 + 4);
  EXPECT_EQ(connectorCount(wired.network), 0);
  const Indices tip = wired.nodes(at(5, 2, 2));
  ASSERT_EQ(tip.size(), 1U);
  EXPECT_NEAR(wired.network.alpha[tip.front()], 2.0 * pi, 1e-13);
  EXPECT_TRUE(wired.network.interior[wired.network.hostOfVertex[wired.vertex(at(5, 2, 2))]]);
}

TEST(WireNetwork, TheLoopAroundAHoleIsAFaceWithoutTriangles)
{
  Surface surface = withCurves(flatPatch(6, 6),
    { curveOf(CurveType::Dart, "eye", { at(6, 3, 2), at(6, 3, 3), at(6, 3, 4) }) });
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
  // A zigzag slit, whose two sides are longer than the boundary of the flat sheet.
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

TEST(WireNetwork, FloatingWiresEncloseAPatchInEachOfTheirLoops)
{
  const Indices ring{ at(8, 4, 4), at(8, 5, 4), at(8, 6, 4), at(8, 6, 5), at(8, 6, 6), at(8, 5, 6),
    at(8, 4, 6), at(8, 4, 5), at(8, 4, 4) };
  // A figure of eight: two patches meet in the vertex where it crosses itself.
  Indices eight = ring;
  eight.insert(eight.end(),
    { at(8, 4, 3), at(8, 4, 2), at(8, 3, 2), at(8, 2, 2), at(8, 2, 3), at(8, 2, 4), at(8, 3, 4),
      at(8, 4, 4) });
  for (const Indices& wire : { ring, eight })
  {
    const WiredSurface wired(withCurves(cushion(8, 8, 0.4), { accessory("floating", wire) }));
    expectConsistent(wired.network);
    EXPECT_EQ(wired.network.patchCount, wire == ring ? 2 : 3);
    EXPECT_EQ(connectorCount(wired.network), 2);
  }
}

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
    return secondsOf([&] { EXPECT_FALSE(findConnectors(mesh, isWire, root).empty()); });
  };
  const double few = std::max({ seconds(60), seconds(60), seconds(60) });
  EXPECT_LT(seconds(240), 200.0 * few);
}

namespace
{
FeatureCurve shapedKey(KeyShape shape, Indices vertices, Points2 planarShape = {})
{
  FeatureCurve curve = curveOf(CurveType::Key, "key", std::move(vertices));
  curve.keyShape = shape;
  curve.planarShape = std::move(planarShape);
  return curve;
}

Indices rowVertices(Index columns, Index j)
{
  return rowCurve(columns, j).vertices;
}

/// Whether the triangle beside a node lies above (larger y) a vertex.
bool isAbove(const WiredSurface& wired, Index node, Index vertex)
{
  const TriangleMesh& mesh = wired.piece.mesh;
  return mesh.centroid(wired.network.halfedge[node] / 3).y() > mesh.point(wired.vertex(vertex)).y();
}

/// Sums of the locked angles at a vertex above and below a horizontal curve.
std::array<double, 2> sidesOf(const WiredSurface& wired, const NodeLocks& locks, Index vertex)
{
  std::array<double, 2> sums{ 0.0, 0.0 };
  for (const Index node : wired.nodes(vertex))
  {
    EXPECT_TRUE(locks.locked[node]);
    sums[isAbove(wired, node, vertex) ? 0 : 1] += locks.angle[node];
  }
  return sums;
}
}

TEST(KeyCurveLocks, FollowEquation1OnTheSurface)
{
  const WiredSurface wired(withCurves(
    cushion(6, 6, 0.5), { shapedKey(KeyShape::Surface, rowVertices(6, 3)), columnCurve(6, 6, 2) }));
  const NodeLocks locks = wired.locks();
  Index locked = 0;
  for (Index i = 0; i <= 6; ++i)
  {
    const Index vertex = 3 * 7 + i;
    double surfaceSum = 0.0;
    for (const Index node : wired.nodes(vertex))
    {
      surfaceSum += wired.network.alpha[node];
    }
    const bool onBoundary = i == 0 || i == 6;
    for (const Index node : wired.nodes(vertex))
    {
      ASSERT_TRUE(locks.locked[node]);
      ++locked;
      const double expected =
        onBoundary ? wired.network.alpha[node] : 2.0 * pi * wired.network.alpha[node] / surfaceSum;
      EXPECT_NEAR(locks.angle[node], expected, 1e-14) << "vertex " << vertex;
    }
  }
  EXPECT_EQ(locked, locks.lockedCount);
  EXPECT_EQ(locked, std::count(locks.locked.begin(), locks.locked.end(), 1));
  EXPECT_EQ(locked, 2 * 7 + 2) << "two nodes a vertex, four where the accessory curve crosses";
}

TEST(KeyCurveLocks, AnglesOnOneSideOfAShapedKeyAreDividedAsOnTheSurface)
{
  const WiredSurface wired(withCurves(cushion(6, 6, 0.5),
    { shapedKey(KeyShape::Straight, rowVertices(6, 3)), columnCurve(6, 6, 2) }));
  const NodeLocks locks = wired.locks();
  const Index vertex = 3 * 7 + 2;
  const Indices nodes = wired.nodes(vertex);
  ASSERT_EQ(nodes.size(), 4U);
  for (const Index a : nodes)
  {
    for (const Index b : nodes)
    {
      if (a != b && isAbove(wired, a, vertex) == isAbove(wired, b, vertex))
      {
        EXPECT_NEAR(
          locks.angle[a] / locks.angle[b], wired.network.alpha[a] / wired.network.alpha[b], 1e-13);
      }
    }
  }
}

TEST(KeyCurveLocks, APlanarShapePrescribesItsTurningWhateverItsSizeAndDirection)
{
  for (const double size : { 1.0, 1e-310, 1e298 })
  {
    Surface surface = cushion(6, 6, 0.5);
    Points2 zigzag{ Point2(0, 0), Point2(10, 0), Point2(20, 5), Point2(30, 0), Point2(40, -20),
      Point2(50, -20), Point2(60, -10) };
    for (Point2& p : zigzag)
    {
      p *= size;
    }
    Indices row = rowVertices(6, 3);
    surface.curves = { shapedKey(KeyShape::Planar, row, zigzag) };
    const WiredSurface wired(surface);
    const NodeLocks locks = wired.locks();
    for (Index i = 1; i < 6; ++i)
    {
      const Point2 in = zigzag[i] - zigzag[i - 1];
      const Point2 out = zigzag[i + 1] - zigzag[i];
      const double left = std::atan2(out.y(), out.x()) - std::atan2(in.y(), in.x());
      // The row runs towards larger x, so larger y is on its left.
      const auto sides = sidesOf(wired, locks, 3 * 7 + i);
      EXPECT_NEAR(sides[0], pi - left, 1e-13) << size;
      EXPECT_NEAR(sides[1], pi + left, 1e-13) << size;
    }
    std::reverse(zigzag.begin(), zigzag.end());
    std::reverse(row.begin(), row.end());
    surface.curves = { shapedKey(KeyShape::Planar, row, zigzag) };
    const NodeLocks backward = WiredSurface(surface).locks();
    EXPECT_EQ(locks.locked, backward.locked);
    EXPECT_LT(largestDifference(locks.angle, backward.angle), 1e-14);
  }
}

TEST(KeyCurveLocks, AClosedKeyIsShapedAtItsFirstVertexToo)
{
  Surface surface = cushion(6, 6, 0.3);
  const auto at = [](Index i, Index j) { return j * 7 + i; };
  Points2 octagon;
  for (int k = 0; k <= 8; ++k)
  {
    octagon.emplace_back(std::cos(k * pi / 4.0), std::sin(k * pi / 4.0));
  }
  const Indices ring{ at(2, 2), at(3, 2), at(4, 2), at(4, 3), at(4, 4), at(3, 4), at(2, 4),
    at(2, 3), at(2, 2) };
  surface.curves = { shapedKey(KeyShape::Planar, ring, octagon) };
  const WiredSurface wired(surface);
  const NodeLocks locks = wired.locks();
  double inside = 0.0;
  for (std::size_t k = 0; k + 1 < ring.size(); ++k)
  {
    for (const Index node : wired.nodes(ring[k]))
    {
      EXPECT_TRUE(locks.locked[node]);
      const Index patch = wired.network.patchOfLoop[wired.network.loop[node]];
      if (patch == wired.network.patchOfTriangle[2 * (3 * 6 + 3)])
      {
        EXPECT_NEAR(locks.angle[node], pi - pi / 4.0, 1e-13);
        inside += locks.angle[node];
      }
    }
  }
  EXPECT_NEAR(inside, 6.0 * pi, 1e-12);
}

TEST(KeyCurveLocks, AStraightKeyAlongTheBoundaryIsStraightOnItsOnlySide)
{
  const WiredSurface wired(
    withCurves(cushion(6, 6, 0.5), { shapedKey(KeyShape::Straight, rowVertices(6, 0)) }));
  const NodeLocks locks = wired.locks();
  EXPECT_EQ(locks.lockedCount, 5);
  for (Index i = 1; i < 6; ++i)
  {
    ASSERT_EQ(wired.nodes(i).size(), 1U);
    EXPECT_NEAR(locks.angle[wired.nodes(i).front()], pi, 1e-14);
  }
}

TEST(KeyCurveLocks, StraightKeysThatCrossAreBothStraight)
{
  const WiredSurface wired(withCurves(cushion(6, 6, 0.5),
    { shapedKey(KeyShape::Straight, rowVertices(6, 3)),
      shapedKey(KeyShape::Straight, columnCurve(6, 6, 3).vertices) }));
  const NodeLocks locks = wired.locks();
  const Indices nodes = wired.nodes(3 * 7 + 3);
  ASSERT_EQ(nodes.size(), 4U);
  const auto sides = sidesOf(wired, locks, 3 * 7 + 3);
  EXPECT_NEAR(sides[0], pi, 1e-13);
  EXPECT_NEAR(sides[1], pi, 1e-13);
  // Opposite angles of two lines are equal.
  std::vector<double> angles;
  for (const Index node : nodes)
  {
    angles.push_back(locks.angle[node]);
  }
  std::sort(angles.begin(), angles.end());
  EXPECT_NEAR(angles[0], angles[1], 1e-13);
  EXPECT_NEAR(angles[2], angles[3], 1e-13);
}

TEST(KeyCurveLocks, AKeyAcrossADartIsShapedOnEachSideOfIt)
{
  // The dart cuts the row in two; at the cut there is nothing for the key to go on with.
  const WiredSurface wired(withCurves(cushion(6, 6, 0.5),
    { shapedKey(KeyShape::Straight, rowVertices(6, 2)),
      curveOf(CurveType::Dart, "dart", { 3, 10, 17, 24 }) }));
  const NodeLocks locks = wired.locks();
  for (Index node = 0; node < wired.network.nodeCount(); ++node)
  {
    const Index v = wired.original(wired.network.vertex[node]);
    const bool inside = v / 7 == 2 && v % 7 > 0 && v % 7 < 6 && v % 7 != 3;
    EXPECT_EQ(locks.locked[node] != 0, inside) << "vertex " << v;
  }
}
