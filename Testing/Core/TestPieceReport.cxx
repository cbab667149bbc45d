// SPDX-License-Identifier: BSD-3-Clause
// What a run reports of its pieces, against what follows from the flat positions by themselves.
#include "Flattened.h"

#include <map>
#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Half the sum of the squared changes of the angles between wires: at each wire vertex those of
/// the triangles of one wire-patch together, in the plane against in space.
double objectiveOfTriangles(const FlatteningResult& result)
{
  const TriangleMesh& mesh = result.cut->mesh;
  std::set<Index> onWires;
  for (const Wire& wire : result.wires)
  {
    onWires.insert(wire.vertices.begin(), wire.vertices.end());
  }
  const auto flat = [&](Index v) {
    return Point3(result.positions[v].x(), result.positions[v].y(), 0.0);
  };
  std::map<std::array<Index, 2>, double> change;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index at = mesh.triangle(t)[k];
      const Index a = mesh.triangle(t)[(k + 1) % 3];
      const Index b = mesh.triangle(t)[(k + 2) % 3];
      if (onWires.count(at))
      {
        change[{ at, result.patchOfTriangle[t] }] +=
          angleBetween(flat(a) - flat(at), flat(b) - flat(at)) - mesh.angle(3 * t + k);
      }
    }
  }
  double sum = 0.0;
  for (const auto& entry : change)
  {
    sum += 0.5 * entry.second * entry.second;
  }
  return sum;
}

Surface cushionWithCross()
{
  return withCurves(cushion(6, 8, 0.3), { columnCurve(6, 8, 3), rowCurve(6, 4) });
}

double perimeterOf(const FlatteningResult& result)
{
  double sum = 0.0;
  for (const Wire& wire : result.wires)
  {
    sum += wire.boundary ? wire.restLength : 0.0;
  }
  return sum;
}

/// The quarter-sphere of Fig. 14 with the arc between the poles elastic.
Surface twoArcs(double tolerance)
{
  Surface surface = quarterSphereWithTwoArcs();
  surface.curves[0].tolerance = tolerance;
  return surface;
}

Surface without(Surface surface, std::size_t curve)
{
  surface.curves.erase(surface.curves.begin() + static_cast<std::ptrdiff_t>(curve));
  return surface;
}
}

TEST(PieceReport, TheObjectiveIsThatOfTheFlatTrianglesInEveryScheme)
{
  for (const Surface& surface : { quarterSphere(), cushionWithCross() })
  {
    for (Scheme scheme :
      { Scheme::Progressive, Scheme::Global, Scheme::Isometric, Scheme::LeastSquaresConformal })
    {
      const FlatteningResult result = flatten(surface, withScheme(scheme));
      ASSERT_FALSE(result.status.refused()) << result.status.message;
      EXPECT_NEAR(result.pieces[0].objective, objectiveOfTriangles(result), 1e-9)
        << static_cast<int>(scheme);
    }
  }
}

TEST(PieceReport, TheClosureIsThatOfTheFlatPiece)
{
  const Surface surface = cushionWithCross();
  for (Scheme scheme : { Scheme::Progressive, Scheme::Global, Scheme::Isometric })
  {
    const FlatteningResult result = flatten(surface, withScheme(scheme));
    EXPECT_LT(result.pieces[0].closureResidual, 1e-11 * perimeterOf(result));
  }
  // A conformal map keeps no length, so loops of the true lengths do not close with its angles.
  const FlatteningResult conformal = flatten(surface, withScheme(Scheme::LeastSquaresConformal));
  EXPECT_GT(conformal.pieces[0].closureResidual, 1e-3 * perimeterOf(conformal));
}

TEST(PieceReport, TheTwoHistoriesAreThoseOfTheirPhases)
{
  const Surface surface = cushionWithCross();
  const FlatteningResult global = flatten(surface, withScheme(Scheme::Global));
  const FlatteningResult isometric = flatten(surface, withScheme(Scheme::Isometric));
  EXPECT_TRUE(global.pieces[0].isometricHistory.empty());
  ASSERT_FALSE(global.pieces[0].history.empty());
  ASSERT_EQ(isometric.pieces[0].history.size(), global.pieces[0].history.size());
  EXPECT_NEAR(isometric.pieces[0].history.back().objective, global.pieces[0].objective, 1e-9);
  const PieceReport& piece = isometric.pieces[0];
  ASSERT_EQ(piece.isometricHistory.size(), static_cast<std::size_t>(piece.iterations) + 1);
  EXPECT_NEAR(piece.isometricHistory.back().energy, piece.distortionEnergy + piece.angleEnergy,
    1e-9 * piece.isometricHistory.back().energy);
}

TEST(PieceReport, AdviceIsWhatFollowingItGivesAlsoWithAnElasticCurve)
{
  for (const double tolerance : { 0.0, 0.02, 0.05, 0.10 })
  {
    const Surface surface = twoArcs(tolerance);
    const FlatteningResult result = flatten(surface, withScheme(Scheme::Global));
    const ReleaseTrial first = result.pieces[0].advice.first();
    ASSERT_TRUE(first.solved);
    EXPECT_EQ(first.curve, 1);
    const FlatteningResult followed = flatten(without(surface, 1), withScheme(Scheme::Global));
    EXPECT_NEAR(first.objective, followed.pieces[0].objective, 1e-9);
  }
}

TEST(PieceReport, AdviceOfTheIsometricSchemeIsWhatFollowingItGives)
{
  const Surface surface = quarterSphereWithTwoArcs();
  const FlatteningResult result = flatten(surface, withScheme(Scheme::Isometric));
  const ReleaseAdvice& advice = result.pieces[0].advice;
  ASSERT_EQ(advice.trials.size(), 2u);
  for (const ReleaseTrial& trial : advice.trials)
  {
    ASSERT_TRUE(trial.solved);
    const FlatteningResult followed = flatten(
      without(surface, static_cast<std::size_t>(trial.curve)), withScheme(Scheme::Isometric));
    EXPECT_NEAR(trial.areaError, followed.pieces[0].quality.areaError, 1e-7);
    EXPECT_NEAR(trial.homogeneity, followed.pieces[0].quality.globalHomogeneity, 1e-7);
    EXPECT_NEAR(trial.objective, followed.pieces[0].objective, 1e-7);
  }
  EXPECT_LE(advice.trials[0].areaError, advice.trials[1].areaError);
}

TEST(PieceReport, TrialsEndWhereAnotherOneWouldTakeMoreWorkThanTheyMay)
{
  const Surface surface = quarterSphereWithTwoArcs();
  const auto tried = [&](double work) {
    FlatteningOptions options;
    options.trialWork = work;
    const FlatteningResult result = flatten(surface, options);
    EXPECT_EQ(result.pieces[0].advice.ranking.size(), 2u); // of all curves, tried or not
    const std::vector<ReleaseTrial>& trials = result.pieces[0].advice.trials;
    return std::count_if(
      trials.begin(), trials.end(), [](const ReleaseTrial& trial) { return trial.solved; });
  };
  EXPECT_EQ(tried(0.0), 0);
  EXPECT_EQ(tried(1e9), 2);
  // Between them is what one takes.
  std::vector<std::ptrdiff_t> counts;
  for (double work = 5e3; work < 2e4; work *= 1.2)
  {
    counts.push_back(tried(work));
  }
  EXPECT_TRUE(std::is_sorted(counts.begin(), counts.end()));
  EXPECT_TRUE(std::binary_search(counts.begin(), counts.end(), 1));
}

TEST(PieceReport, AdviceWithoutTrialsRanksBySensitivityAndChangesNothingElse)
{
  const Surface surface = quarterSphereWithTwoArcs();
  for (const Scheme scheme : { Scheme::Global, Scheme::Isometric })
  {
    FlatteningOptions options = withScheme(scheme);
    options.tryReleases = false;
    const FlatteningResult result = flatten(surface, options);
    const FlatteningResult tried = flatten(surface, withScheme(scheme));
    EXPECT_EQ(result.positions, tried.positions);
    EXPECT_TRUE(tried.pieces[0].advice.first().solved);
    const ReleaseAdvice& advice = result.pieces[0].advice;
    ASSERT_EQ(advice.ranking.size(), 2u);
    EXPECT_FALSE(advice.first().solved);
    EXPECT_GE(std::abs(result.curves[advice.ranking[0]].sensitivity),
      std::abs(result.curves[advice.ranking[1]].sensitivity));
  }
}

TEST(PieceReport, TheSolverThatWasUsedIsNamedAndWhyItIsAnother)
{
  Surface surface = quarterSphere();
  FlatteningOptions options = withScheme(Scheme::Global);
  options.angles.method = AngleMethod::Sequential;
  const auto report = [&] { return flatten(surface, options).pieces[0]; };
  EXPECT_EQ(report().solverUsed, AngleMethod::Sequential);
  EXPECT_TRUE(report().fallbacks.empty());
  surface.curves[0].tolerance = 0.05;
  EXPECT_EQ(report().solverUsed, AngleMethod::Newton);
  ASSERT_EQ(report().fallbacks.size(), 1u);
  EXPECT_NE(report().fallbacks[0].find("elastic"), std::string::npos);
  options.scheme = Scheme::LeastSquaresConformal;
  EXPECT_FALSE(report().solverUsed.has_value());
}

TEST(PieceReport, ARepairOfProgressiveAnglesIsTold)
{
  // A grid of wires on a strongly curved surface: patches in the middle inherit all their angles.
  Surface surface = cushion(6, 6, 0.4);
  EXPECT_FALSE(flatten(surface, withScheme(Scheme::Progressive)).pieces[0].repaired);
  for (Index k = 1; k < 6; ++k)
  {
    surface.curves.push_back(rowCurve(6, k));
    surface.curves.push_back(columnCurve(6, 6, k));
  }
  const PieceReport repaired = flatten(surface, withScheme(Scheme::Progressive)).pieces[0];
  EXPECT_TRUE(repaired.repaired);
  EXPECT_EQ(repaired.fallbacks.size(), 1u);
  EXPECT_TRUE(repaired.status.ok()) << repaired.status.message;
  EXPECT_EQ(repaired.warpingOrder.size(), 36u);
  EXPECT_LT(repaired.quality.maximumEdgeLengthError, 1e-12);
  EXPECT_FALSE(flatten(surface, withScheme(Scheme::Global)).pieces[0].repaired);
}

TEST(PieceReport, ARelaxationThatRunsOutOfIterationsHasNotConverged)
{
  const Surface surface = cushion(12, 12, 0.4);
  FlatteningOptions options = withScheme(Scheme::Global);
  options.interior.method = InteriorMethod::Relaxation;
  const auto run = [&] { return flatten(surface, options); };
  EXPECT_TRUE(run().status.ok()) << run().status.message;
  options.interior.maximumIterations = options.interior.minimumIterations;
  EXPECT_EQ(run().status.code, StatusCode::NotConverged);
  EXPECT_EQ(run().status.remedies.front().remedy, Remedy::AllowRelaxationIterations);
  // The isometric scheme starts there alone, and ends at its minimum.
  options.scheme = Scheme::Isometric;
  EXPECT_TRUE(run().status.ok()) << run().status.message;
}
