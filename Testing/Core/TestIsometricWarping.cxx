// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/IsometricWarping.h"

#include "Flattened.h"
#include "Imprint/CurveImprint.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
FlatteningOptions isometricWith(DistortionEnergy energy, double angleWeight = 5.0)
{
  FlatteningOptions options;
  options.isometric.energy = energy;
  options.isometric.angleWeight = angleWeight;
  return options;
}

Surface cushionWithCurves()
{
  Surface surface = cushion(8, 10, 0.3);
  surface.curves = { columnCurve(8, 10, 4), rowCurve(8, 3), rowCurve(8, 7) };
  return surface;
}

/// The same with room between the wires for them to bend.
Surface fineCushionWithCurves()
{
  Surface surface = cushion(16, 20, 0.3);
  surface.curves = { columnCurve(16, 20, 8), rowCurve(16, 6), rowCurve(16, 14) };
  return surface;
}

/// A cone and a cylinder with two curves that cross.
std::array<Surface, 2> developables()
{
  std::array<Surface, 2> surfaces{ cone(12, 6), cylinder(10, 8) };
  surfaces[0].curves = { rowCurve(12, 3), columnCurve(12, 6, 6) };
  surfaces[1].curves = { rowCurve(10, 4), columnCurve(10, 8, 5) };
  return surfaces;
}
}

TEST(IsometricWarping, KeepsEveryWireExactAndBeatsThePinnedInterior)
{
  const Surface surface = fineCushionWithCurves();
  const FlatteningResult before = flatten(surface, withScheme(Scheme::Global));
  const FlatteningResult after = flatten(surface);
  ASSERT_TRUE(after.status.ok()) << after.status.message;
  const QualitySummary& a = before.pieces[0].quality;
  const QualitySummary& b = after.pieces[0].quality;
  EXPECT_LT(b.maximumEdgeLengthError, 1e-12);
  EXPECT_LT(b.angleError, a.angleError);
  EXPECT_LT(b.areaError, a.areaError);
  EXPECT_GT(b.globalHomogeneity, a.globalHomogeneity);
  EXPECT_TRUE(b.flipped.empty());
}

TEST(IsometricWarping, ConvergesQuadraticallyToAStationaryPoint)
{
  const FlatteningResult result = flatten(cushionWithCurves());
  const auto& history = result.pieces[0].history;
  ASSERT_GE(history.size(), 3u);
  EXPECT_LE(result.pieces[0].iterations, 8);
  EXPECT_LT(history.back().optimality, 1e-9 * std::sqrt(history.back().objective) + 1e-11);
  // The last step squares the error, up to a constant.
  const double last = history[history.size() - 1].step;
  const double before = history[history.size() - 2].step;
  EXPECT_LT(last, 10.0 * before * before + 1e-12);
}

TEST(IsometricWarping, AFinerMeshOfTheSameSurfaceGivesTheSameShape)
{
  // The same cushion with a curve along its middle, 60 and 120 triangles across.
  std::array<double, 2> angleError{};
  std::array<double, 2> width{};
  for (int fine = 0; fine < 2; ++fine)
  {
    const Index side = fine ? 120 : 60;
    Surface surface = cushion(side, side, 0.15);
    surface.curves.push_back(rowCurve(side, side / 2));
    const FlatteningResult result = flatten(surface);
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    angleError[fine] = result.pieces[0].quality.angleError;
    Eigen::AlignedBox2d box;
    for (const Point2& p : result.positions)
    {
      box.extend(p);
    }
    width[fine] = box.diagonal().norm();
  }
  EXPECT_NEAR(angleError[1], angleError[0], 0.03 * angleError[0]);
  EXPECT_NEAR(width[1], width[0], 2e-3 * width[0]);
}

TEST(IsometricWarping, TheQuarterSphereStaysSymmetricInBothDirections)
{
  // The paper's splits of the quads break both mirrors; with splits that mirror each other the
  // surface has them, and so must the flat piece.
  Surface surface = quarterSphere();
  Triangles triangles = surface.mesh.triangles();
  const Points3& space = surface.mesh.points();
  for (std::size_t t = 0; t + 1 < triangles.size(); ++t)
  {
    Triangle& first = triangles[t];
    Triangle& second = triangles[t + 1];
    // (i, j), (i + 1, j + 1), (i, j + 1) and (i, j), (i + 1, j), (i + 1, j + 1) make up a quad.
    if (first[0] == 0 || first[0] != second[0] || first[1] != second[2])
    {
      continue;
    }
    ++t; // the quad's second triangle starts no other
    const Point3 middle = 0.5 * (space[first[0]] + space[first[1]]);
    if ((middle.x() > middle.y()) != (middle.z() > 0.0))
    {
      const Index a = first[0];
      const Index c = first[1];
      const Index d = first[2];
      const Index b = second[1];
      first = { a, b, d };
      second = { b, c, d };
    }
  }
  surface.mesh = TriangleMesh(space, triangles);
  const FlatteningResult result = flatten(surface);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LT(result.pieces[0].quality.maximumEdgeLengthError, 1e-12);
  const auto mirrorError = [&](const std::function<Point3(const Point3&)>& mirror) {
    Points2 image;
    for (const Point3& p : space)
    {
      std::size_t partner = 0;
      for (std::size_t w = 0; w < space.size(); ++w)
      {
        if ((space[w] - mirror(p)).norm() < (space[partner] - mirror(p)).norm())
        {
          partner = w;
        }
      }
      EXPECT_LT((space[partner] - mirror(p)).norm(), 1e-12);
      image.emplace_back(-result.positions[partner].x(), result.positions[partner].y());
    }
    return rigidDistance(result.positions, image);
  };
  EXPECT_LT(mirrorError([](const Point3& p) { return Point3(p.y(), p.x(), p.z()); }), 1e-9);
  EXPECT_LT(mirrorError([](const Point3& p) { return Point3(p.x(), p.y(), -p.z()); }), 1e-9);
}

TEST(IsometricWarping, StopsWhereSliversLeaveOnlyRoundingInTheGradient)
{
  // Curves between places inside triangles divide these into thin ones.
  const Surface panel = cone(12, 10);
  std::mt19937 random(5);
  const auto place = [&] {
    const Index t = static_cast<Index>(random() % panel.mesh.triangleCount());
    const Triangle& corners = panel.mesh.triangle(t);
    const double a = random() / 4294967296.0;
    const double b = (1.0 - a) * (random() / 4294967296.0);
    return Point3(a * panel.mesh.point(corners[0]) + b * panel.mesh.point(corners[1]) +
      (1.0 - a - b) * panel.mesh.point(corners[2]));
  };
  int imprintedOnes = 0;
  for (int trial = 0; trial < 20; ++trial)
  {
    Polyline line;
    line.name = "across";
    line.points = { place(), place() };
    const ImprintedSurface imprinted = imprintCurves(panel.mesh, { line }, {});
    if (!imprinted.status.ok())
    {
      continue; // the section may leave the panel
    }
    ++imprintedOnes;
    const FlatteningResult result = flatten({ imprinted.mesh, imprinted.curves, {} });
    EXPECT_TRUE(result.status.ok()) << trial << ": " << result.status.message;
    EXPECT_LT(result.pieces[0].iterations, 20) << trial;
    EXPECT_NEAR(result.pieces[0].quality.globalHomogeneity, 1.0, 1e-6) << trial;
  }
  EXPECT_GE(imprintedOnes, 10);
}

TEST(IsometricWarping, StopsOnAFineMeshWhereTheRoundingOfAllLengthsIsWhatIsLeft)
{
  constexpr Index n = 99;
  const auto place = [](double i, double j) {
    const double x = 10.0 * i / n;
    const double y = 10.0 * j / n;
    return Point3(x, y, 0.3 * std::sin(0.5 * x) * std::cos(0.4 * y) + 0.2 * std::sin(x * y / 3.0));
  };
  const Surface sheet = patch(n, n, place);
  Polyline row;
  for (Index i = 0; i <= n; ++i)
  {
    row.points.push_back(place(i, 50));
  }
  Polyline across;
  across.points = { place(5, 5), place(33, 50), place(6, 90) };
  const ImprintedSurface imprinted = imprintCurves(sheet.mesh, { row, across }, {});
  ASSERT_TRUE(imprinted.status.ok()) << imprinted.status.message;
  const FlatteningResult result = flatten({ imprinted.mesh, imprinted.curves, {} });
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LT(result.pieces[0].iterations, 20);
  EXPECT_LT(result.pieces[0].quality.maximumEdgeLengthError, 1e-11);
}

TEST(IsometricWarping, SymmetricDirichletNeverFlipsAndAgreesOnDevelopables)
{
  const FlatteningOptions dirichlet =
    isometricWith({ DistortionEnergyKind::SymmetricDirichlet, 0.0 });
  const FlatteningResult result = flatten(cushionWithCurves(), dirichlet);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LT(result.pieces[0].quality.maximumEdgeLengthError, 1e-12);
  EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
  EXPECT_EQ(countFlipped(result.cut->mesh, result.positions), 0);

  // Where there is an isometry, it has no energy of either kind.
  for (const Surface& surface : developables())
  {
    const FlatteningResult one = flatten(surface);
    const FlatteningResult other = flatten(surface, dirichlet);
    ASSERT_TRUE(other.status.ok()) << other.status.message;
    EXPECT_LT(rigidDistance(one.positions, other.positions), 1e-9);
    EXPECT_LT(rigidDistance(surface.unrolled, other.positions), 1e-9);
  }
  // Elsewhere they are two.
  EXPECT_GT(rigidDistance(flatten(cushionWithCurves()).positions, result.positions), 1e-4);
}

TEST(IsometricWarping, ABiasTowardsAreaLowersTheAreaErrorAndTowardsAngleTheAngleError)
{
  const Surface surface = cushionWithCurves();
  const auto quality = [&](double bias) {
    return flatten(surface, isometricWith({ DistortionEnergyKind::AsRigidAsPossible, bias }))
      .pieces[0]
      .quality;
  };
  EXPECT_LT(quality(0.8).areaError, quality(0.0).areaError);
  EXPECT_LT(quality(-0.8).angleError, quality(0.0).angleError);
}

TEST(IsometricWarping, ALargerAngleWeightKeepsTheWiresAnglesNearer)
{
  const Surface surface = cushionWithCurves();
  const double loose = flatten(surface, isometricWith({}, 1.0)).pieces[0].angleEnergy / 1.0;
  const double tight = flatten(surface, isometricWith({}, 10.0)).pieces[0].angleEnergy / 10.0;
  EXPECT_LT(tight, loose);
}
