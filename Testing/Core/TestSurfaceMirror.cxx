// SPDX-License-Identifier: BSD-3-Clause
// Planes of symmetry, and surfaces that are their own mirror image as cloth, not in space: folded
// along a line beside such a plane, which changes no length and no angle on them.
#include "Suggestion/CutMesh.h"
#include "Suggestion/SurfaceMirror.h"
#include "Suggestion/SymmetryPlane.h"
#include "SuggestionTesting.h"
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

namespace
{
constexpr double foldAt = 0.8;

/// A bump that ends in the flat sheet around it.
double bump(double x, double y, double height)
{
  const double square = (x * x + y * y) / 0.16;
  return square < 1.0 ? height * (1.0 - square) * (1.0 - square) : 0.0;
}

/// Turns what lies at x > foldAt about the line there: an isometry, since the sheet is flat there.
Point3 folded(const Point3& p, double angle)
{
  const double out = std::max(0.0, p.x() - foldAt);
  return { p.x() - out * (1.0 - std::cos(angle)), p.y(), p.z() + out * std::sin(angle) };
}

Point3 unfolded(const Point3& p, double angle)
{
  return p.x() > foldAt ? Point3(foldAt + (p.x() - foldAt) / std::cos(angle), p.y(), 0.0) : p;
}

/// A sheet of 2 by 1.4 with a bump on each side of x = 0, folded at one of its sides.
TriangleMesh foldedBumps(double angle, double other = 0.25)
{
  return patch(20, 14, [&](double i, double j) {
    const double x = i / 10.0 - 1.0;
    const double y = j / 10.0;
    const double height = bump(std::abs(x) - 0.4, y - 0.9, x > 0.0 ? 0.25 : other);
    return folded({ x, y, height }, angle);
  }).mesh;
}

/// The same surface by triangles of which none has another one as its image.
TriangleMesh unevenBumps(double angle)
{
  return patch(40, 28, [&](double i, double j) {
    const double u = i / 20.0 - 1.0;
    const double x = u + 0.03 * (1.0 - u * u) * (u - foldAt);
    const double y = j / 20.0;
    return folded({ x, y, bump(std::abs(x) - 0.4, y - 0.9, 0.25) }, angle);
  }).mesh;
}

double lengthOf(const Polyline& line)
{
  double length = 0.0;
  for (std::size_t k = 1; k < line.points.size(); ++k)
  {
    length += (line.points[k] - line.points[k - 1]).norm();
  }
  return length;
}
}

TEST(IntrinsicMirror, IsFoundWhereBendingHasHiddenIt)
{
  constexpr double angle = 1.0;
  const TriangleMesh mesh = foldedBumps(angle);
  ASSERT_FALSE(findSymmetryPlane(mesh).has_value());
  const std::shared_ptr<const IntrinsicMirror> mirror = IntrinsicMirror::find(mesh, {});
  ASSERT_NE(mirror, nullptr);
  EXPECT_LT(mirror->error(), 1e-9);
  const TriangleMesh flat = foldedBumps(0.0);
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const Point3& p = flat.point(v);
    const Point3 image = folded({ -p.x(), p.y(), p.z() }, angle);
    EXPECT_LT((mirror->mirrored(mesh.point(v)) - image).norm(), 1e-9) << v;
    EXPECT_NEAR(mirror->side(mesh.point(v)) + mirror->side(image), 0.0, 1e-9) << v;
    EXPECT_NEAR(mirror->projected(mesh.point(v)).x(), 0.0, 1e-9) << v;
  }
  for (const Point3& end : mirror->axis())
  {
    EXPECT_NEAR(end.x(), 0.0, 1e-9);
    EXPECT_LT(std::min(std::abs(end.y()), std::abs(end.y() - 1.4)), 1e-9);
  }
}

TEST(IntrinsicMirror, IsNotFoundWhereOneSideIsHigher)
{
  EXPECT_EQ(IntrinsicMirror::find(foldedBumps(1.0, 0.1), {}), nullptr);
}

TEST(IntrinsicMirror, CutsComeInPairsOfTheSameLength)
{
  constexpr double angle = 1.0;
  for (const bool mirrored : { true, false }) // triangle by triangle
  {
    const CurveSuggestions suggestions =
      suggestCurves(mirrored ? foldedBumps(angle) : unevenBumps(angle), {},
        optionsOf(0.0, 2, SuggestedCuts::Darts));
    ASSERT_TRUE(suggestions.mirror.has_value());
    ASSERT_NE(suggestions.mirror->intrinsic(), nullptr);
    EXPECT_EQ(suggestions.mirror->error > 1e-6, !mirrored);
    ASSERT_EQ(suggestions.curves.size(), 2U);
    EXPECT_EQ(suggestions.curves[1].mirrorOf, 0);
    const Polyline& cut = suggestions.curves[0].curve;
    const Polyline& image = suggestions.curves[1].curve;
    EXPECT_TRUE(mirrored || lengthOf(cut) > 0.1);
    EXPECT_NEAR(lengthOf(image), lengthOf(cut), 1e-12);
    ASSERT_TRUE(!mirrored || cut.points.size() == image.points.size());
    for (std::size_t k = 0; mirrored && k < cut.points.size(); ++k)
    {
      const Point3 p = unfolded(cut.points[k], angle);
      const Point3 q = unfolded(image.points[k], angle);
      EXPECT_LT((Point3(-p.x(), p.y(), p.z()) - q).norm(), 1e-9) << k;
    }
  }
}

TEST(CutMesh, DividesACutEdgeAcrossTheMirrorSoThatTwoTrianglesMeetAtEach)
{
  CutMesh half;
  half.mesh = TriangleMesh(
    { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0.5, 0.5 }, { 1, 0.5, -0.5 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  half.cut.assign(half.mesh.halfedgeCount(), 0);
  half.cut[half.mesh.find(0, 1)] = half.cut[half.mesh.find(1, 0)] = 1;
  const std::optional<MirrorSection> mirror = MirrorSection{ SymmetryPlane(), 1e-6 };
  const CutMesh whole = bothSides(withoutBridges(half, mirror), mirror);
  EXPECT_EQ(whole.mesh.triangleCount(), 8);
  EXPECT_TRUE(crowdedEdges(sortedSides(whole.mesh.triangles(), whole.mesh.vertexCount())).empty());
  EXPECT_NEAR(whole.mesh.area(), 2.0 * half.mesh.area(), 1e-15);
  double length = 0.0; // of cut edges, from both sides
  for (Index h = 0; h < whole.mesh.halfedgeCount(); ++h)
  {
    EXPECT_EQ(whole.images[whole.images[h]], h);
    EXPECT_EQ(whole.cut[whole.images[h]], whole.cut[h]);
    length += whole.cut[h] ? whole.mesh.length(h) : 0.0;
  }
  EXPECT_NEAR(length, 4.0, 1e-15); // the edge and its image
}

TEST(CutMesh, HalvesOfARingWhoseVerticesAreOnlyNearToThePlaneFitTogether)
{
  TriangleMesh ring = moved(torus(30, 3.0), [](const Point3& p) -> Point3 {
    return p + (std::abs(p.z()) < 1e-9 ? 3e-3 * std::sin(7.0 * p.x()) : 0.0) * Point3::UnitZ();
  });
  SymmetryPlane plane;
  plane.normal = Point3::UnitZ();
  std::optional<MirrorSection> mirror = sectionOf(ring, plane);
  CutMesh half;
  half.mesh = halfOf(ring, *mirror);
  half.cut.assign(half.mesh.halfedgeCount(), 0);
  const TriangleMesh whole = bothSides(withoutBridges(half, mirror), mirror).mesh;
  EXPECT_GE(whole.triangleCount(), 1800);
  EXPECT_TRUE(whole.boundaryLoops().empty());
  EXPECT_EQ(eulerCharacteristic(whole), 0);
}
