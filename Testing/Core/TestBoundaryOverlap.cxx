// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Orientation.h"
#include "Quality/BoundaryOverlap.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
using Pairs = std::vector<std::array<Index, 2>>;

/// A strip laid along an arc of the plane of the given angle: past 2 pi its ends lie on each other.
Points2 arc(Index columns, double angle, double rise = 0.0)
{
  Points2 positions;
  for (Index j = 0; j <= 2; ++j)
  {
    for (Index i = 0; i <= columns; ++i)
    {
      const double turn = -angle * i / columns;
      const double radius = 1.0 + 0.1 * j + rise * i / columns;
      positions.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
    }
  }
  return positions;
}

/// All pairs of boundary edges that share no vertex and have a point in common.
Pairs allPairs(const TriangleMesh& mesh, const Points2& positions)
{
  Indices boundary;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      boundary.push_back(h);
    }
  }
  Pairs pairs;
  for (Index g : boundary)
  {
    for (Index h : boundary)
    {
      const Index a = mesh.from(g);
      const Index b = mesh.to(g);
      const Index c = mesh.from(h);
      const Index d = mesh.to(h);
      if (g < h && a != c && a != d && b != c && b != d &&
        segmentsMeet(positions[a], positions[b], positions[c], positions[d]))
      {
        pairs.push_back({ g, h });
      }
    }
  }
  return pairs;
}

/// A square with a cut from the middle of its lower side to its centre.
struct Slit
{
  TriangleMesh mesh;
  Points2 positions;

  Slit()
    : mesh(
        cutSurface(unitSquares(6, 6).mesh, { curveOf(CurveType::Dart, "cut", { 3, 10, 17, 24 }) })
          .mesh)
  {
    for (const Point3& p : this->mesh.points())
    {
      this->positions.emplace_back(p.x(), p.y());
    }
  }

  /// Moves the right side to the right, all but the tip.
  Points2 opened(double width) const
  {
    Points2 moved = this->positions;
    for (Index t = 0; t < this->mesh.triangleCount(); ++t)
    {
      for (Index v : this->mesh.triangle(t))
      {
        const Point2& p = this->positions[v];
        if (this->mesh.centroid(t).x() > 3.0 && p.x() == 3.0 && p.y() < 3.0)
        {
          moved[v].x() = 3.0 + width;
        }
      }
    }
    return moved;
  }
};
}

TEST(BoundaryOverlap, AStripBentPastAFullTurnOverlapsAndOneBeforeItDoesNot)
{
  const Surface strip = cone(40, 2);
  EXPECT_TRUE(findBoundaryOverlaps(strip.mesh, arc(40, 6.2), 1000).empty());
  const Pairs pairs = findBoundaryOverlaps(strip.mesh, arc(40, 6.6), 1000);
  EXPECT_FALSE(pairs.empty());
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& pair : pairs)
  {
    EXPECT_EQ(strip.mesh.twin(pair[0]), none);
    EXPECT_EQ(strip.mesh.twin(pair[1]), none);
  }
  // Risen by more than its width, the strip is a spiral and free again.
  EXPECT_TRUE(findBoundaryOverlaps(strip.mesh, arc(40, 6.6, 0.3), 1000).empty());
}

TEST(BoundaryOverlap, CountsAllOfThemHoweverFewItLists)
{
  // A long strip wound up 40 times between two radii: every turn crosses every other one.
  const Surface strip = cone(3000, 1);
  Points2 positions;
  for (Index j = 0; j <= 1; ++j)
  {
    for (Index i = 0; i <= 3000; ++i)
    {
      const double turn = -80.0 * pi * i / 3000.0;
      const double radius = 1.0 + 0.1 * j + 0.3 * std::sin(turn * 2.0 / 3.0);
      positions.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
    }
  }
  const Pairs pairs = allPairs(strip.mesh, positions);
  ASSERT_GT(pairs.size(), 2 * mostListedOverlaps);
  for (const std::size_t listed : { std::size_t{ 0 }, mostListedOverlaps, pairs.size() + 1 })
  {
    const BoundaryOverlaps overlaps = countBoundaryOverlaps(strip.mesh, positions, listed, 0.0);
    EXPECT_TRUE(overlaps.complete);
    EXPECT_EQ(overlaps.count, pairs.size());
    EXPECT_EQ(overlaps.listed.size(), std::min(listed, pairs.size()));
    EXPECT_TRUE(
      std::includes(pairs.begin(), pairs.end(), overlaps.listed.begin(), overlaps.listed.end()));
  }
}

TEST(BoundaryOverlap, SaysWhereItHasNotLookedAtAll)
{
  const Surface strip = cone(400, 1);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  Points2 positions(strip.mesh.vertexCount());
  for (Point2& p : positions)
  {
    p = Point2(place(random), place(random));
  }
  const std::size_t all = allPairs(strip.mesh, positions).size();
  const BoundaryOverlaps few = countBoundaryOverlaps(strip.mesh, positions, 10, 0.0, 5000);
  EXPECT_FALSE(few.complete);
  EXPECT_GT(few.count, 0u);
  EXPECT_LT(few.count, all);
  EXPECT_EQ(few.listed.size(), 10u);
  const BoundaryOverlaps enough = countBoundaryOverlaps(strip.mesh, positions, 10, 0.0);
  EXPECT_TRUE(enough.complete);
  EXPECT_EQ(enough.count, all);
}

TEST(BoundaryOverlap, FindsTheSamePairsAsComparingAll)
{
  const Surface strip = cone(60, 2);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (int k = 0; k < 20; ++k)
  {
    Points2 positions = arc(60, 5.0 + 0.3 * k);
    for (Point2& p : positions)
    {
      p += 0.05 * Point2(place(random), place(random));
    }
    EXPECT_EQ(
      findBoundaryOverlaps(strip.mesh, positions, 1000000, 0.0), allPairs(strip.mesh, positions));
  }
}

TEST(BoundaryOverlap, SidesThatTouchAreNoOverlap)
{
  const Slit slit;
  ASSERT_EQ(slit.mesh.vertexCount(), 49 + 3);
  const TriangleMesh& mesh = slit.mesh;
  ASSERT_FALSE(allPairs(mesh, slit.positions).empty()) << "the sides do touch";
  EXPECT_TRUE(findBoundaryOverlaps(mesh, slit.positions, 100).empty());
  // also not where rounding turned and bent them through each other
  for (double angle : { 0.3, 1.0, 2.0 })
  {
    Points2 turned;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-1e-13, 1e-13);
    for (const Point2& p : slit.positions)
    {
      turned.push_back(
        Eigen::Rotation2Dd(angle) * p + Point2(100.0 + noise(random), -30.0 + noise(random)));
    }
    EXPECT_TRUE(findBoundaryOverlaps(mesh, turned, 100).empty());
  }
}

TEST(BoundaryOverlap, SidesThatPassEachOtherAreAnOverlap)
{
  const Slit slit;
  const TriangleMesh& mesh = slit.mesh;
  EXPECT_TRUE(findBoundaryOverlaps(mesh, slit.opened(0.2), 100).empty());
  EXPECT_FALSE(findBoundaryOverlaps(mesh, slit.opened(-0.2), 100).empty());
  EXPECT_FALSE(findBoundaryOverlaps(mesh, slit.opened(-1e-6), 100).empty());
}

TEST(BoundaryOverlap, PiecesSideBySideAreFreeAndOnTopOfEachOtherAreNot)
{
  const TriangleMesh two = together({ flatPatch(4, 3), flatPatch(4, 3) }).mesh;
  const auto besides = [&](const Point2& shift) {
    Points2 positions;
    for (Index v = 0; v < 40; ++v)
    {
      positions.push_back(Point2(v % 20 % 5, v % 20 / 5) + (v < 20 ? Point2(0, 0) : shift));
    }
    return findBoundaryOverlaps(two, positions, 1000);
  };
  EXPECT_TRUE(besides(Point2(5, 0)).empty());
  EXPECT_TRUE(besides(Point2(4, 0)).empty()) << "edge to edge";
  EXPECT_TRUE(besides(Point2(4, 3)).empty()) << "corner to corner";
  EXPECT_TRUE(besides(Point2(4, 0.5)).empty()) << "vertices on edges";
  EXPECT_FALSE(besides(Point2(3.9, 0)).empty());
  EXPECT_FALSE(besides(Point2(0, 0)).empty());
  EXPECT_FALSE(besides(Point2(2, 1)).empty()) << "boundaries that cross in vertices only";
}

namespace
{
__extension__ using Wide = __int128;

/// Exact for coordinates that are multiples of 2^-53 below 32.
int exactSign(const Point2& a, const Point2& b, const Point2& c)
{
  const auto integer = [](double x) { return static_cast<Wide>(std::ldexp(x, 53)); };
  const Wide left = (integer(a.x()) - integer(c.x())) * (integer(b.y()) - integer(c.y()));
  const Wide right = (integer(a.y()) - integer(c.y())) * (integer(b.x()) - integer(c.x()));
  return left > right ? 1 : left < right ? -1 : 0;
}
}

TEST(Orientation, IsExactWhereRoundingDecidesThePlainFormula)
{
  // Points one rounding step apart, near the line through the two others.
  const Point2 b(12.0, 12.0);
  const Point2 c(24.0, 24.0);
  int wrong = 0;
  for (int i = 0; i < 64; ++i)
  {
    for (int j = 0; j < 64; ++j)
    {
      const Point2 a(0.5 + std::ldexp(i, -53), 0.5 + std::ldexp(j, -53));
      const int exact = exactSign(a, b, c);
      const double plain = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
      wrong += (plain > 0.0) - (plain < 0.0) != exact ? 1 : 0;
      ASSERT_EQ(orientation(a, b, c), exact) << i << ' ' << j;
      ASSERT_EQ(orientation(b, c, a), exact);
      ASSERT_EQ(orientation(b, a, c), -exact);
    }
  }
  EXPECT_GT(wrong, 0) << "the case is too easy to tell anything";
}

TEST(Orientation, IsExactOnRandomNearlyCollinearPoints)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(1, std::int64_t(1) << 53);
  std::uniform_int_distribution<int> nudge(-2, 2);
  const auto real = [](std::int64_t k) { return std::ldexp(static_cast<double>(k), -53); };
  for (int k = 0; k < 20000; ++k)
  {
    const Point2 a(real(coordinate(random)), real(coordinate(random)));
    const Point2 b(real(coordinate(random)), real(coordinate(random)));
    const double t = real(coordinate(random));
    // back onto the grid of multiples of 2^-53
    const Point2 between = a + t * (b - a);
    const Point2 c(std::ldexp(std::round(std::ldexp(between.x(), 53)) + nudge(random), -53),
      std::ldexp(std::round(std::ldexp(between.y(), 53)) + nudge(random), -53));
    ASSERT_EQ(orientation(a, b, c), exactSign(a, b, c));
  }
}

TEST(Orientation, SegmentsMeetWhenTheyCrossTouchOrLieOnEachOther)
{
  const Point2 o(0, 0);
  const Point2 e(4, 0);
  EXPECT_TRUE(segmentsMeet(o, e, Point2(1, -1), Point2(2, 1)));
  EXPECT_TRUE(segmentsMeet(o, e, Point2(1, 0), Point2(2, 1)));
  EXPECT_TRUE(segmentsMeet(o, e, Point2(4, 0), Point2(5, 1)));
  EXPECT_TRUE(segmentsMeet(o, e, Point2(3, 0), Point2(6, 0)));
  EXPECT_TRUE(segmentsMeet(o, e, Point2(1, 0), Point2(2, 0)));
  EXPECT_FALSE(segmentsMeet(o, e, Point2(5, 0), Point2(6, 0)));
  EXPECT_FALSE(segmentsMeet(o, e, Point2(1, 1), Point2(2, 0.001)));
  EXPECT_FALSE(segmentsMeet(o, e, Point2(1, 1e-300), Point2(2, 1)));
}
