// SPDX-License-Identifier: BSD-3-Clause
#include "StraightRay.h"

#include "PathFacts.h"
#include "Paths/StraightPath.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

TEST(StraightRay, IsAStraightPathOfItsLength)
{
  for (const Surface& surface : { flatPatch(30, 25), cone(40, 20), cylinder(30, 15) })
  {
    const TriangleMesh& mesh = surface.mesh;
    const double size = std::sqrt(mesh.area(0) * mesh.triangleCount());
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int arrived = 0;
    for (int k = 0; k < 500; ++k)
    {
      const SurfacePoint start = randomPoint(mesh, random);
      const PointDirections around(mesh, start);
      const double angle = around.total() * unit(random);
      const SurfaceDirection direction = around.at(angle);
      ASSERT_NE(direction.triangle, none);
      const double length = 0.2 * size * unit(random);
      const StraightRay ray = straightRay(mesh, start, direction, length);
      const Point2 way =
        unrolled(mesh, surface.unrolled, ray.end) - unrolled(mesh, surface.unrolled, start);
      if (ray.arrived)
      {
        EXPECT_NEAR(way.norm(), length, 1e-12 * size) << k;
        ++arrived;
      }
      else
      {
        EXPECT_LT(way.norm(), length);
        EXPECT_TRUE(ray.end.type == SurfacePointType::Vertex ? mesh.onBoundary(ray.end.id)
                                                             : mesh.twin(ray.end.id) == none);
      }
    }
    EXPECT_GT(arrived, 300);
  }
}

TEST(StraightRay, DirectionsAreAnglesOfTheUnrolledSurface)
{
  const Surface surface = cone(40, 20);
  const TriangleMesh& mesh = surface.mesh;
  std::mt19937 random(2);
  int measured = 0;
  for (int k = 0; k < 300; ++k)
  {
    const SurfacePoint start = randomPoint(mesh, random);
    const PointDirections around(mesh, start);
    const Point2 from = unrolled(mesh, surface.unrolled, start);
    bool arrived = true;
    double angles[2];
    Point2 ways[2];
    for (int side = 0; side < 2; ++side)
    {
      angles[side] = around.total() * (side == 0 ? 0.1 : 0.1 + 0.008 * (k % 100));
      const StraightRay ray = straightRay(mesh, start, around.at(angles[side]), 1e-3);
      ways[side] = unrolled(mesh, surface.unrolled, ray.end) - from;
      arrived = arrived && ray.arrived;
    }
    if (!arrived) // at the boundary
    {
      continue;
    }
    ++measured;
    const double turn =
      std::atan2(ways[0].x() * ways[1].y() - ways[0].y() * ways[1].x(), ways[0].dot(ways[1]));
    EXPECT_NEAR(std::remainder(turn - (angles[1] - angles[0]), 2.0 * pi), 0.0, 1e-9) << k;
  }
  EXPECT_GT(measured, 250);
}

TEST(StraightRay, GoesOnAlongAStraightBoundary)
{
  const Surface plate = patch(10, 4, [](double i, double j) { return Point3(i, j, 0.0); });
  const PointDirections around(plate.mesh, vertexPoint(plate.mesh, 0));
  const double along = around.angleTo(0, plate.mesh.point(1));
  const StraightRay ray =
    straightRay(plate.mesh, vertexPoint(plate.mesh, 0), around.at(along), 7.25);
  ASSERT_TRUE(ray.arrived);
  EXPECT_EQ(ray.end.type, SurfacePointType::Edge);
  EXPECT_LE((ray.end.position - Point3(7.25, 0.0, 0.0)).norm(), 1e-12);
  const StraightRay far =
    straightRay(plate.mesh, vertexPoint(plate.mesh, 0), around.at(along), 12.0);
  EXPECT_FALSE(far.arrived);
  EXPECT_LE((far.end.position - Point3(10.0, 0.0, 0.0)).norm(), 1e-12);
}

TEST(StraightRay, LeavesEqualAnglesOnBothSidesOfAVertex)
{
  // A pyramid of four sides: a ray up one edge goes down the one across.
  const Points3 points{ { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 } };
  const TriangleMesh mesh(points, { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } });
  const SurfacePoint start = vertexPoint(mesh, 0);
  const PointDirections around(mesh, start);
  const StraightRay ray =
    straightRay(mesh, start, around.at(around.angleTo(0, points[4])), 2.0 * std::sqrt(2.0) - 0.5);
  ASSERT_TRUE(ray.arrived);
  EXPECT_LE((ray.end.position - (points[2] + 0.5 * Point3(1, 0, 1).normalized())).norm(), 1e-12);
}
