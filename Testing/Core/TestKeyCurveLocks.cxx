// SPDX-License-Identifier: BSD-3-Clause
#include "WiredSurface.h"

using namespace flattening;
using namespace testmeshes;

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
  Surface surface = cushion(6, 6, 0.5);
  surface.curves = { shapedKey(KeyShape::Surface, rowVertices(6, 3)), columnCurve(6, 6, 2) };
  const WiredSurface wired(surface);
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
  Surface surface = cushion(6, 6, 0.5);
  surface.curves = { shapedKey(KeyShape::Straight, rowVertices(6, 3)), columnCurve(6, 6, 2) };
  const WiredSurface wired(surface);
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
  Surface surface = cushion(6, 6, 0.5);
  surface.curves = { shapedKey(KeyShape::Straight, rowVertices(6, 0)) };
  const WiredSurface wired(surface);
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
  Surface surface = cushion(6, 6, 0.5);
  surface.curves = { shapedKey(KeyShape::Straight, rowVertices(6, 3)),
    shapedKey(KeyShape::Straight, columnCurve(6, 6, 3).vertices) };
  const WiredSurface wired(surface);
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
  Surface surface = cushion(6, 6, 0.5);
  surface.curves = { shapedKey(KeyShape::Straight, rowVertices(6, 2)),
    curveOf(CurveType::Dart, "dart", { 3, 10, 17, 24 }) };
  const WiredSurface wired(surface);
  const NodeLocks locks = wired.locks();
  for (Index node = 0; node < wired.network.nodeCount(); ++node)
  {
    const Index v = wired.original(wired.network.vertex[node]);
    const bool inside = v / 7 == 2 && v % 7 > 0 && v % 7 < 6 && v % 7 != 3;
    EXPECT_EQ(locks.locked[node] != 0, inside) << "vertex " << v;
  }
}
