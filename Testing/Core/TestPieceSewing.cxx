// SPDX-License-Identifier: BSD-3-Clause
#include "Renumbered.h"
#include "SewnPieces.h"
#include "TestThreads.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

TEST(PieceSewing, DevelopablePanelsReturnToTheirDesign)
{
  for (const Surface& surface : { cylinder(24, 12), cone(24, 12) })
  {
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
  EXPECT_LE(report.measures.distanceMean, report.measures.distanceRms);
  EXPECT_LE(report.measures.distanceRms, report.measures.distanceMax);
  EXPECT_LE(report.measures.distanceP95, report.measures.distanceMax);
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
  ASSERT_EQ(one.points.size(), three.points.size());
  for (std::size_t v = 0; v < one.points.size(); ++v)
  {
    EXPECT_EQ(one.points[v], three.points[v]);
  }
  EXPECT_EQ(one.shapes.front().measures.distanceMean, three.shapes.front().measures.distanceMean);
}

TEST(PieceSewing, ALonePanelWithAFreeBoundaryIsRefused)
{
  const SewingResult result = sewn(dome(), product());
  EXPECT_EQ(result.status.code, StatusCode::InvalidOption);
  EXPECT_NE(result.status.message.find("sewn to nothing"), std::string::npos);
  ASSERT_EQ(result.status.remedies.size(), 1U);
  EXPECT_EQ(result.status.remedies.front().remedy, Remedy::TestPanels);
  EXPECT_TRUE(result.points.empty());
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
}

TEST(PieceSewing, SaysWhereItIsNotAtRestAndStopsWhenTold)
{
  SewingOptions options = panel();
  options.maximumIterations = 1;
  const SewingResult early = sewn(dome(), options);
  EXPECT_EQ(early.status.code, StatusCode::NotConverged);
  EXPECT_FALSE(early.shapes.front().converged);
  EXPECT_FALSE(early.points.empty());

  const FlatteningResult pieces = flatten(dome());
  Execution run;
  run.cancel = [] { return true; };
  const SewingResult cancelled = sewPieces(*pieces.cut, pieces.positions, panel(), run);
  EXPECT_EQ(cancelled.status.code, StatusCode::Cancelled);
  EXPECT_TRUE(cancelled.points.empty());
}
