// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SymmetryPlane.h"

#include "TestMeshes.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A sheet of 2 by 1.4 with bumps, turned and moved away from all axes. Its x was across the plane
/// x = 0. \param other height of the bump at x < 0, that at x > 0 is 0.3 high
TriangleMesh turnedBumps(const Eigen::Isometry3d& place, double other)
{
  return patch(20, 14, [&](double i, double j) {
    const double x = i / 10.0 - 1.0;
    const double y = j / 10.0;
    const double square = (std::abs(x) - 0.5) * (std::abs(x) - 0.5) + (y - 0.9) * (y - 0.9);
    const double height = x > 0.0 ? 0.3 : other;
    return Point3(place * Point3(x, y, height * std::exp(-9.0 * square)));
  }).mesh;
}

Eigen::Isometry3d somewhere()
{
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translate(Point3(3.0, -7.0, 2.0));
  place.rotate(Eigen::AngleAxisd(0.9, Point3(1.0, 2.0, -0.5).normalized()));
  return place;
}
}

TEST(SymmetryPlane, IsFoundHoweverTheSurfaceIsTurned)
{
  const Eigen::Isometry3d place = somewhere();
  const std::optional<SymmetryPlane> plane = findSymmetryPlane(turnedBumps(place, 0.3));
  ASSERT_TRUE(plane.has_value());
  EXPECT_NEAR(std::abs(plane->normal.dot(place.linear().col(0))), 1.0, 1e-12);
  EXPECT_NEAR(plane->side(place.translation()), 0.0, 1e-9);
  EXPECT_LT(plane->error, 1e-9);
}

TEST(SymmetryPlane, IsNotFoundWhereOneSideIsHigher)
{
  EXPECT_FALSE(findSymmetryPlane(turnedBumps(somewhere(), 0.1)).has_value());
}

TEST(SymmetryPlane, IsRefinedFromThePrincipalAxes)
{
  // A piece cut away on one side turns the principal axes, and the surface stays its own image but
  // for the edge of the hole: within the tolerance given.
  const Eigen::Isometry3d place = somewhere();
  const TriangleMesh whole = turnedBumps(place, 0.3);
  Triangles left(whole.triangles().begin() + 12, whole.triangles().end());
  const TriangleMesh mesh(whole.points(), std::move(left));
  const std::optional<SymmetryPlane> plane = findSymmetryPlane(mesh, 0.02);
  ASSERT_TRUE(plane.has_value());
  EXPECT_GT(std::abs(plane->normal.dot(place.linear().col(0))), std::cos(0.02));
}

TEST(SymmetryPlane, OfAFlatSheetIsAcrossIt)
{
  // All of it lies in z = 0, which mirrors any flat sheet; only the trapezium has an axis.
  const auto sheet = [](double slantLeft, double slantRight) {
    const Eigen::Rotation2Dd turn(0.5);
    return patch(20, 14, [&](double i, double j) {
      const double x = i / 10.0 - 1.0;
      const double y = j / 10.0;
      const Point2 turned = turn * Point2(x + y * (x < 0.0 ? -slantLeft : slantRight) * x * x, y);
      return Point3(turned.x(), turned.y(), 0.0);
    }).mesh;
  };
  const std::optional<SymmetryPlane> plane = findSymmetryPlane(sheet(0.3, 0.3));
  ASSERT_TRUE(plane.has_value());
  EXPECT_NEAR(std::abs(plane->normal.dot(Point3(std::cos(0.5), std::sin(0.5), 0.0))), 1.0, 1e-12);
  EXPECT_FALSE(findSymmetryPlane(sheet(0.5, 0.0)).has_value());
}
