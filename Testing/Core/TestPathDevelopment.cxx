// SPDX-License-Identifier: BSD-3-Clause
#include "PathFacts.h"
#include "Paths/PathGraph.h"
#include "Paths/PathPoints.h"
#include "Paths/PathShortening.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Sections from vertex to vertex.
SurfacePath through(const TriangleMesh& mesh, const SnapDistance& snap, const Indices& vertices)
{
  SurfacePath path;
  path.points = { vertexPoint(mesh, vertices.front()) };
  for (std::size_t k = 1; k < vertices.size(); ++k)
  {
    append(path, traceSegment(mesh, snap, path.points.back(), vertexPoint(mesh, vertices[k])));
  }
  return path;
}

/// A sheet of 80 x 80 squares that is flat, rolled up, or wavy.
TriangleMesh sheet(const std::function<Point3(double, double)>& place)
{
  return patch(80, 80, place).mesh;
}

Index at(Index i, Index j)
{
  return j * 81 + i;
}
}

TEST(PathDevelopment, OfAPathOnAFlatOrRolledSheetIsTheStraightLine)
{
  const TriangleMesh flat = sheet([](double i, double j) { return Point3(i, j, 0.0); });
  // Chords of the roll, as wide as long, so that lengths are those of the flat one.
  const double turn = 0.02;
  const double radius = 0.5 / std::sin(0.5 * turn);
  const TriangleMesh rolled = sheet([=](double i, double j) {
    return Point3(radius * std::cos(turn * i), radius * std::sin(turn * i), j);
  });
  for (const TriangleMesh* mesh : { &flat, &rolled })
  {
    const PathGraph graph(*mesh);
    for (const Indices& vertices :
      { Indices{ at(2, 3), at(40, 76), at(77, 9) }, Indices{ at(2, 3), at(70, 20), at(15, 77) },
        Indices{ at(5, 40), at(30, 75), at(60, 8), at(78, 41) } })
    {
      const SurfacePath path = through(*mesh, graph.noSnap(), vertices);
      const SurfacePath straight = developed(*mesh, graph.noSnap(), path);
      const Point2 way(
        vertices.back() % 81 - vertices.front() % 81, vertices.back() / 81 - vertices.front() / 81);
      EXPECT_TRUE(straight.arrived);
      EXPECT_TRUE(liesOn(*mesh, straight));
      EXPECT_GT(lengthOf(path), 1.2 * way.norm());
      EXPECT_LT(lengthOf(straight), way.norm() * (1.0 + 1e-6)); // sections are not quite straight
      EXPECT_GE(lengthOf(straight), way.norm() * (1.0 - 1e-12));
    }
  }
}

TEST(PathDevelopment, OfAPathOnARollOfManyTurnsIsTheStraightLine)
{
  // Chords as wide as long; no plane section between far points goes round with the path.
  const double turn = 0.3;
  const double radius = 0.5 / std::sin(0.5 * turn);
  const TriangleMesh roll = sheet([=](double i, double j) {
    return Point3(radius * std::cos(turn * i), radius * std::sin(turn * i), j);
  });
  const PathGraph graph(roll);
  const SurfacePath path = through(roll, graph.noSnap(),
    { at(2, 3), at(10, 20), at(18, 35), at(26, 50), at(34, 60), at(42, 70), at(50, 60), at(58, 50),
      at(66, 35), at(74, 20), at(78, 9) });
  const SurfacePath straight = developed(roll, graph.noSnap(), path);
  const double way = std::hypot(76.0, 6.0);
  EXPECT_TRUE(straight.arrived);
  EXPECT_TRUE(liesOn(roll, straight));
  EXPECT_GT(lengthOf(path), 1.4 * way);
  EXPECT_LT(lengthOf(straight), way * (1.0 + 1e-3)); // sections are not quite straight
  EXPECT_GE(lengthOf(straight), way * (1.0 - 1e-12));
}

TEST(PathDevelopment, IsNeverLongerAndKeepsTheEnds)
{
  std::mt19937 random(8);
  for (const double height : { 1.0, 4.0, 12.0 })
  {
    const TriangleMesh mesh = sheet([=](double i, double j) {
      return Point3(i, j, height * std::sin(0.11 * i) * std::cos(0.09 * j));
    });
    const PathGraph graph(mesh);
    int shorter = 0;
    for (int k = 0; k < 60; ++k)
    {
      Indices vertices;
      for (int n = 0; n < 3; ++n)
      {
        vertices.push_back(static_cast<Index>(random() % mesh.vertexCount()));
      }
      const SurfacePath path = through(mesh, graph.noSnap(), vertices);
      if (!path.arrived || path.triangles.empty())
      {
        continue; // a section met the boundary
      }
      const SurfacePath next = developed(mesh, graph.noSnap(), path);
      ASSERT_TRUE(next.arrived);
      EXPECT_TRUE(liesOn(mesh, next));
      EXPECT_TRUE(samePlace(next.points.front(), path.points.front()));
      EXPECT_TRUE(samePlace(next.points.back(), path.points.back()));
      EXPECT_LE(lengthOf(next), lengthOf(path));
      shorter += lengthOf(next) < 0.95 * lengthOf(path) ? 1 : 0;
    }
    EXPECT_GT(shorter, 5);
  }
}

// Near the top of a hill a path is nearly straight, and has far to go.
TEST(PathDevelopment, GoesFartherThanTheChordDownFromAHill)
{
  const TriangleMesh mesh = sheet([](double i, double j) {
    return Point3(
      i, j, 45.0 * std::exp(-0.002 * ((i - 40.0) * (i - 40.0) + (j - 40.0) * (j - 40.0))));
  });
  const PathGraph graph(mesh);
  const SurfacePath over = through(mesh, graph.noSnap(), { at(2, 40), at(40, 41), at(78, 40) });
  const SurfacePath moved = developed(mesh, graph.noSnap(), over);
  double aside = 0.0;
  for (const SurfacePoint& point : moved.points)
  {
    aside = std::max(aside, point.position.y() - 40.0);
  }
  EXPECT_GT(aside, 4.0);
  EXPECT_LT(lengthOf(moved), 0.97 * lengthOf(over));
}

TEST(PathDevelopment, LeavesWhatIsStraight)
{
  const TriangleMesh mesh = sheet([](double i, double j) { return Point3(i, j, 0.0); });
  const PathGraph graph(mesh);
  const SurfacePath path = through(mesh, graph.noSnap(), { at(2, 40), at(77, 43) });
  const SurfacePath same = developed(mesh, graph.noSnap(), path);
  EXPECT_NEAR(lengthOf(same), std::hypot(75.0, 3.0), 1e-9);
  EXPECT_LE(lengthOf(same), lengthOf(path));
}
