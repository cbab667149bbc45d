// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedMeshes.h"
#include "Cloth/ClothMaterial.h"
#include "Flattened.h"
#include "Renumbered.h"
#include "Sewing/PieceSewing.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
SewingResult sewn(const Surface& surface, const SewingOptions& options, const Execution& run = {})
{
  const FlatteningResult result = flatten(surface);
  return sewPieces(*result.cut, result.positions, options, run);
}

SewingOptions product(double thickness = 1e-3)
{
  SewingOptions options;
  options.test = SewingTest::Product;
  options.thickness = thickness;
  return options;
}

SewingOptions panel(double thickness = 1e-3)
{
  SewingOptions options;
  options.thickness = thickness;
  return options;
}

/// A frustum about the z axis (radius 1 below) with seams along two opposite rulings.
Surface frustum(Index columns, Index rows, double upperRadius)
{
  Surface surface;
  surface.mesh =
    revolved(columns, rows, 2.0, [=](double height) { return 1.0 + (upperRadius - 1.0) * height; });
  for (const Index i : { Index(0), columns / 2 })
  {
    Indices vertices;
    for (Index j = 0; j <= rows; ++j)
    {
      vertices.push_back(j * columns + i);
    }
    surface.curves.push_back(curveOf(CurveType::Seam, "seam" + std::to_string(i), vertices));
  }
  return surface;
}

/// A patch that is no developable: the sheet has to give.
Surface dome()
{
  return cushion(12, 12, 0.2);
}
}

TEST(PieceSewing, DevelopablePanelsOfSheetsAndThreadsReturnToTheirDesign)
{
  SewingOptions threads = panel(1e-6);
  threads.material = *findPreset("twill");
  for (const Surface& surface : { cylinder(24, 12), cone(24, 12) })
  {
    const SewingResult woven = sewn(surface, threads);
    ASSERT_TRUE(woven.status.ok()) << woven.status.message;
    const SewnReport& report = woven.shapes.front();
    EXPECT_LT(report.measures.distanceMax, 1e-6 * report.measures.size);
    EXPECT_LT(report.threads->summary.warpRms + report.threads->summary.weftRms, 1e-7);
    EXPECT_EQ(woven.threads.size(), surface.mesh.triangles().size());

    const SewingResult result = sewn(surface, panel(1e-6));
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    ASSERT_EQ(result.shapes.size(), 1U);
    EXPECT_GT(result.shapes.front().iterations, 0);
    const SewnMeasures& measures = result.shapes.front().measures;
    EXPECT_GT(measures.distanceMax, 0.0);
    EXPECT_LT(measures.distanceMax, 1e-6 * measures.size);
    EXPECT_LT(measures.strainMax, 1e-8);
    EXPECT_LT(measures.normalDeviationMean, 1e-4);
    EXPECT_EQ(measures.compressedArea, 0.0);
  }
}

TEST(PieceSewing, BendingMovesADevelopableByTheSquareOfItsThickness)
{
  const Surface surface = cylinder(24, 12);
  const auto distance = [&surface](double thickness) {
    const SewnReport report = sewn(surface, panel(thickness)).shapes.front();
    EXPECT_GT(report.iterations, 0);
    return report.measures.distanceMax;
  };
  EXPECT_NEAR(distance(1e-5) / distance(1e-6), 100.0, 10.0);
}

TEST(PieceSewing, ClosedCylinderAndConeOfTwoPiecesComeToRestAsDesignedWithoutPins)
{
  for (const double upperRadius : { 1.0, 0.5 })
  {
    const SewingResult result = sewn(frustum(32, 8, upperRadius), product());
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    ASSERT_EQ(result.shapes.size(), 1U);
    EXPECT_EQ(result.shapes.front().pieces, 2);
    const SewnMeasures& measures = result.shapes.front().measures;
    EXPECT_LT(measures.distanceMax, 0.005 * measures.size);
    EXPECT_LT(measures.strainMax, 1e-4);
    for (const std::array<double, 2>& strain : result.seamStrain)
    {
      EXPECT_LT(std::abs(strain[0]) + std::abs(strain[1]), 1e-4);
    }
  }
}

TEST(PieceSewing, SeamsAreShared)
{
  const FlatteningResult pieces = flatten(frustum(16, 4, 0.7));
  const SewingResult result = sewPieces(*pieces.cut, pieces.positions, product(), {});
  for (const SeamPair& pair : pieces.cut->seamPairs)
  {
    const TriangleMesh& mesh = pieces.cut->mesh;
    EXPECT_EQ(result.points[mesh.from(pair.first)], result.points[mesh.to(pair.second)]);
    EXPECT_EQ(result.points[mesh.to(pair.first)], result.points[mesh.from(pair.second)]);
  }
}

TEST(PieceSewing, APanelKeepsItsBoundaryAndMovesInside)
{
  const FlatteningResult pieces = flatten(dome());
  const TriangleMesh& mesh = pieces.cut->mesh;
  const SewingResult result = sewPieces(*pieces.cut, pieces.positions, panel(), {});
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  double farthest = 0.0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const double moved = (result.points[v] - mesh.point(v)).norm();
    farthest = std::max(farthest, moved);
    EXPECT_TRUE(!mesh.onBoundary(v) || moved == 0.0);
  }
  const SewnReport& report = result.shapes.front();
  EXPECT_GT(farthest, 1e-3);
  EXPECT_GT(report.measures.distanceMean, 0.0);
  EXPECT_LT(report.history.back().energy, report.history.front().energy);
  // At rest it bears less than the flattening says of the design.
  EXPECT_LT(report.measures.strainP95, pieces.pieces.front().quality.strainP95);
}

TEST(PieceSewing, TheDistanceIsThatOfTheFinerMeshAsWell)
{
  const double coarse = sewn(cushion(12, 12, 0.2), panel()).shapes.front().measures.distanceMean;
  const double fine = sewn(cushion(24, 24, 0.2), panel()).shapes.front().measures.distanceMean;
  EXPECT_NEAR(coarse / fine, 1.0, 0.15);
}

TEST(PieceSewing, MotionUnitAndNumberingChangeNothing)
{
  const Surface surface = dome();
  const SewnReport report = sewn(surface, panel()).shapes.front();

  Surface turned = surface;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Point3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  turned.mesh = moved(surface.mesh,
    [&](const Point3& p) -> Point3 { return 1000.0 * (turn * p) + Point3(20.0, -70.0, 5.0); });
  std::mt19937 random(4);
  Indices place;
  const std::vector<std::pair<Surface, double>> others{ { turned, 1000.0 },
    { renumbered(surface, random, place), 1.0 } };
  for (const auto& [other, scale] : others)
  {
    const SewnReport again = sewn(other, panel()).shapes.front();
    EXPECT_NEAR(again.measures.size / scale / report.measures.size, 1.0, 1e-12);
    EXPECT_NEAR(again.measures.distanceMean / scale / report.measures.distanceMean, 1.0, 1e-6);
    EXPECT_NEAR(again.measures.distanceMax / scale / report.measures.distanceMax, 1.0, 1e-6);
    EXPECT_NEAR(again.measures.strainP95 / report.measures.strainP95, 1.0, 1e-6);
    EXPECT_NEAR(again.membraneEnergy / (scale * scale) / report.membraneEnergy, 1.0, 1e-6);
  }
}

TEST(PieceSewing, ThreadsChangeNoBit)
{
  const FlatteningResult pieces = flatten(dome());
  const SewingResult one = sewPieces(*pieces.cut, pieces.positions, panel(), {});
  const SewingResult three = sewPieces(*pieces.cut, pieces.positions, panel(), withThreads(3));
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.shapes.front().measures.distanceMean, three.shapes.front().measures.distanceMean);
}

TEST(PieceSewing, RefusesWhatItCannotSew)
{
  const FlatteningResult pieces = flatten(dome());
  const auto code = [&pieces](const Points2& positions, const SewingOptions& options) {
    return sewPieces(*pieces.cut, positions, options, {}).status.code;
  };
  EXPECT_EQ(code(pieces.positions, panel(-1.0)), StatusCode::InvalidOption);
  EXPECT_EQ(code(pieces.positions, panel(std::nan(""))), StatusCode::InvalidOption);
  EXPECT_EQ(code({}, panel()), StatusCode::InvalidOption);
  EXPECT_EQ(code(Points2(pieces.positions.size(), Point2(1.0, 1.0)), panel()),
    StatusCode::DegenerateTriangle);
  EXPECT_EQ(sewPieces({}, {}, panel(), {}).status.code, StatusCode::EmptySurface);
  SewingOptions options = panel();
  options.material.emplace();
  const SewingResult refused = sewn(dome(), options);
  EXPECT_EQ(refused.status.code, StatusCode::InvalidOption);
  EXPECT_NE(refused.status.message.find("stiffness"), std::string::npos);
  EXPECT_TRUE(refused.points.empty());
}

TEST(PieceSewing, LeavesNothingWhenItIsCancelled)
{
  Execution run;
  run.cancel = [] { return true; };
  const SewingResult cancelled = sewn(dome(), panel(), run);
  EXPECT_EQ(cancelled.status.code, StatusCode::Cancelled);
  EXPECT_TRUE(cancelled.points.empty());
}

namespace
{
/// A sphere of radius 1 whose eight gores meet at seams along meridians.
Surface sphereOfGores(Index perGore, Index rows)
{
  const Index columns = 8 * perGore;
  Surface surface;
  surface.mesh = betweenPoles(columns, rows, [](double angle, double polar) {
    return Point3(
      std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
  });
  for (Index i = 0; i < columns; i += perGore)
  {
    Indices vertices{ 0 };
    for (Index j = 1; j < rows; ++j)
    {
      vertices.push_back(2 + (j - 1) * columns + i);
    }
    vertices.push_back(1);
    surface.curves.push_back(curveOf(CurveType::Seam, "seam" + std::to_string(i), vertices));
  }
  return surface;
}

/// The pattern of globes and balloons: each gore as high as its meridian is long, and as wide at
/// each latitude as its circle there.
Points2 sinusoidalGores(const CutSurface& cut)
{
  Points2 positions(cut.mesh.vertexCount());
  for (const Triangle& c : cut.mesh.triangles())
  {
    const Point3 middle = cut.mesh.point(c[0]) + cut.mesh.point(c[1]) + cut.mesh.point(c[2]);
    const double gore = pi / 4.0;
    const double center = gore * (std::floor(std::atan2(middle.y(), middle.x()) / gore) + 0.5);
    for (Index v : c)
    {
      const Point3& p = cut.mesh.point(v);
      const double width = std::hypot(p.x(), p.y());
      const double angle = width > 1e-9 ? std::atan2(p.y(), p.x()) - center : 0.0;
      positions[v] = { width * std::remainder(angle, 2.0 * pi), std::atan2(p.z(), width) };
    }
  }
  return positions;
}
}

TEST(SewnCloth, ASphereOfEightGoresUnderPressureHasItsRadius)
{
  const CutSurface cut = [] {
    const Surface sphere = sphereOfGores(4, 24);
    return cutSurface(sphere.mesh, sphere.curves);
  }();
  ASSERT_EQ(cut.pieceCount, 8);
  const Points2 gores = sinusoidalGores(cut);
  SewingOptions options = product();
  options.pressure = 0.01;
  const SewingResult result = sewPieces(cut, gores, options, {});
  ASSERT_FALSE(result.status.refused()) << result.status.message;
  EXPECT_TRUE(result.shapes.front().converged);
  // Of the ball of the same volume.
  const auto radius = [&cut](const Points3& points) {
    double volume = 0.0;
    for (const Triangle& c : cut.mesh.triangles())
    {
      volume += points[c[0]].dot(points[c[1]].cross(points[c[2]])) / 6.0;
    }
    return std::cbrt(0.75 * volume / pi);
  };
  EXPECT_NEAR(radius(result.points) / radius(cut.mesh.points()), 1.0, 0.01);
  // Pressure holds it out: without, it caves in or stays smaller.
  options.pressure = 0.0;
  const SewingResult slack = sewPieces(cut, gores, options, {});
  EXPECT_GT(
    slack.shapes.front().measures.distanceMean, result.shapes.front().measures.distanceMean);
}

TEST(SewnCloth, WhatIsOpenHoldsNoPressure)
{
  SewingOptions options = product();
  options.pressure = 0.01;
  const SewingResult result = sewn(frustum(16, 4, 0.7), options);
  EXPECT_EQ(result.status.code, StatusCode::InvalidOption);
  EXPECT_NE(result.status.message.find("holds no pressure"), std::string::npos);
  options.pressure = std::nan("");
  EXPECT_EQ(sewn(frustum(16, 4, 0.7), options).status.code, StatusCode::InvalidOption);
}

TEST(SewnCloth, ClothDoesNotGoThroughABody)
{
  // A plane that faces down, across the top of the dome.
  const double height = 0.04;
  const TriangleMesh plane(
    { { -9.0, -9.0, height }, { -9.0, 9.0, height }, { 9.0, 9.0, height }, { 9.0, -9.0, height } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
  SewingOptions options = panel();
  options.body = &plane;
  const SewingResult result = sewn(dome(), options);
  ASSERT_FALSE(result.status.refused()) << result.status.message;
  EXPECT_EQ(result.shapes.front().bodyDepth, 0.0);
  double highest = 0.0;
  for (const Point3& p : result.points)
  {
    highest = std::max(highest, p.z());
  }
  EXPECT_LT(highest, height);
  // It lies against it, at no more than the gap.
  EXPECT_GT(highest, height - 1.5e-3);
  double without = 0.0;
  for (const Point3& p : sewn(dome(), panel()).points)
  {
    without = std::max(without, p.z());
  }
  EXPECT_GT(without, height);
}

TEST(SewnCloth, ABodyThatIsNotTouchedChangesNothing)
{
  const TriangleMesh plane(
    { { -9.0, -9.0, -1.0 }, { 9.0, -9.0, -1.0 }, { 9.0, 9.0, -1.0 }, { -9.0, 9.0, -1.0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
  SewingOptions options = panel();
  options.body = &plane;
  const SewnReport with = sewn(dome(), options).shapes.front();
  const SewnReport without = sewn(dome(), panel()).shapes.front();
  EXPECT_NEAR(with.measures.distanceMean / without.measures.distanceMean, 1.0, 1e-6);
}

TEST(SewnCloth, ASecondStartOfAClosedFrustumFindsItsShapeAgain)
{
  EXPECT_FALSE(sewn(frustum(32, 8, 0.5), product()).shapes.front().severalShapes);
}

TEST(SewnCloth, ASheetThatIsTooLargeForItsFrameHasAShapeAtRestOnEachSide)
{
  // Nothing but the frame, which is plane, tells cloth where the design is: what is at rest above
  // the frame is so below, and only the design tells the two apart. So thick it has no other shape.
  const Surface surface = cushion(12, 12, 0.03);
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  Points2 larger;
  for (const Point3& p : cut.mesh.points())
  {
    larger.emplace_back(1.02 * p.x(), 1.02 * p.y());
  }
  const SewingResult result = sewPieces(cut, larger, panel(0.04), {});
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  const SewnReport& report = result.shapes.front();
  EXPECT_TRUE(report.severalShapes);
  const SewnTopology topology = sewnShapes(cut, larger, SewingTest::Panel);
  Points3 mirrored;
  double height = 0.0;
  for (Index v : topology.shapes.front().vertices)
  {
    const Point3& p = result.points[v];
    height = std::max(height, p.z());
    mirrored.emplace_back(p.x(), p.y(), -p.z());
  }
  EXPECT_GT(height, 0.06);
  const double other = measureSewn(topology.shapes.front().cloth, mirrored, {}).distanceMean;
  EXPECT_GT(other, 1.3 * report.measures.distanceMean);
  EXPECT_NEAR(report.secondDistance / other, 1.0, 1e-4);
}

TEST(SewnCloth, ALongFlatPanelSagsUnderItsWeightAsASupportedBeam)
{
  // In the middle 5 q a^4 / (384 D) across, with D = modulus thickness^2 / 12; ten times as long as
  // wide. Edges along and across and one diagonal: what bends as a cylinder bends as a plate.
  const Index columns = 16;
  const Index rows = 10 * columns;
  Surface plate =
    patch(columns, rows, [=](double i, double j) -> Point3 { return Point3(i, j, 0.0) / columns; });
  plate.mesh = TriangleMesh(plate.mesh.points(), gridTriangles(columns, rows));
  const double size = std::sqrt(10.0);
  const double thickness = 0.01;
  const double weight = 1e-8;
  SewingOptions options = panel(thickness / size);
  options.gravity = { 0.0, 0.0, -weight * size };
  options.secondStart = false;
  const SewingResult result = sewn(plate, options);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  const double sag = -result.points[at(columns, columns / 2, rows / 2)].z();
  EXPECT_NEAR(sag * 384.0 / 5.0 * thickness * thickness / 12.0 / weight, 1.0, 0.005);
}

TEST(SewnCloth, TurningThePiecesByARightAngleIsSwappingWarpAndWeft)
{
  const Surface surface = dome();
  const FlatteningResult pieces = flatten(surface);
  SewingOptions options = panel();
  options.material = *findPreset("jersey");
  options.secondStart = false;
  const SewingResult upright = sewPieces(*pieces.cut, pieces.positions, options, {});
  Points2 turned;
  for (const Point2& p : pieces.positions)
  {
    turned.emplace_back(-p.y(), p.x());
  }
  std::swap(options.material->warp, options.material->weft);
  const SewingResult across = sewPieces(*pieces.cut, turned, options, {});
  ASSERT_TRUE(upright.status.ok() && across.status.ok());
  const SewnReport& a = upright.shapes.front();
  const SewnReport& b = across.shapes.front();
  EXPECT_GT(a.threads->summary.warpRms, 1e-4);
  EXPECT_NEAR(a.threads->summary.warpRms, b.threads->summary.weftRms, 1e-9);
  EXPECT_NEAR(a.threads->summary.weftRms, b.threads->summary.warpRms, 1e-9);
  EXPECT_NEAR(a.measures.distanceMean, b.measures.distanceMean, 1e-9);
  // Not as the isotropic sheet lies, which has no threads.
  options.material.reset();
  const SewingResult sheet = sewPieces(*pieces.cut, pieces.positions, options, {});
  const double plain = sheet.shapes.front().measures.distanceMean;
  EXPECT_GT(std::abs(plain - a.measures.distanceMean), 1e-3 * a.measures.distanceMean);
  EXPECT_TRUE(sheet.threads.empty());
}
