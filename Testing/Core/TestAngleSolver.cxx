// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/AngleProblem.h"
#include "Angles/AngleSolver.h"
#include "Angles/DirectionsForm.h"
#include "Angles/KeyRelease.h"
#include "Angles/ReleaseAdvice.h"
#include "Flattened.h"
#include "ModelDerivatives.h"
#include "Reference/ProgressiveWarping.h"
#include "Reference/SequentialAngleSolver.h"
#include "WiredSurface.h"

#include <Eigen/QR>
#include <Eigen/SparseCholesky>

#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
AngleSolution solve(const AngleProblem& problem, AngleMethod method)
{
  AngleSolverOptions options;
  options.method = method;
  return solveAngles(problem, options, {});
}

/// Optimality without the solvers' own multipliers: the part of the objective's gradient that no
/// combination of the constraints' gradients explains.
double unexplainedGradient(const AngleProblem& problem, const std::vector<double>& theta)
{
  const AngleConstraints constraints(problem);
  Eigen::VectorXd gradient(constraints.freeCount());
  for (Index k = 0; k < constraints.freeCount(); ++k)
  {
    const Index node = constraints.freeNodes()[k];
    gradient[k] = problem.weight[node] * (theta[node] - problem.target[node]);
  }
  const Eigen::MatrixXd A = Eigen::MatrixXd(constraints.jacobian(theta)).transpose();
  const Eigen::VectorXd multipliers = A.completeOrthogonalDecomposition().solve(gradient);
  return (gradient - A * multipliers).cwiseAbs().maxCoeff();
}

double worstConstraint(const AngleProblem& problem, const std::vector<double>& theta)
{
  return AngleConstraints(problem).residual(theta).cwiseAbs().maxCoeff();
}

/// Moderately curved surfaces with every kind of wire.
std::vector<Surface> curvedSurfaces()
{
  const FeatureCurve key = rowCurve(8, 4, CurveType::Key);
  FeatureCurve straight = key;
  straight.keyShape = KeyShape::Straight;
  std::vector<Surface> surfaces{ quarterSphere() };
  for (const std::vector<FeatureCurve>& curves : std::vector<std::vector<FeatureCurve>>{
         { rowCurve(8, 2), rowCurve(8, 4), columnCurve(8, 6, 3) },
         { rowCurve(8, 2), key, columnCurve(8, 6, 3) },
         { rowCurve(8, 2), straight, columnCurve(8, 6, 3) },
         { curveOf(CurveType::Dart, "dart", { 4, 13, 22 }), rowCurve(8, 4),
           accessory("to the dart", { 9, 10, 11, 12, 13 }) },
         { accessory("dangling", { 4, 13, 22, 31 }) } })
  {
    surfaces.push_back(cushion(8, 6, 0.15));
    surfaces.back().curves = curves;
  }
  return surfaces;
}
}

TEST(AngleSolver, BothMethodsMeetTheConstraintsAndAgreeOnAStationaryPoint)
{
  for (const Surface& surface : curvedSurfaces())
  {
    const WiredSurface wired(surface);
    const AngleProblem problem = wired.problem();
    const AngleSolution newton = solve(problem, AngleMethod::Newton);
    const AngleSolution sequential = solve(problem, AngleMethod::Sequential);
    for (const AngleSolution& solution : { newton, sequential })
    {
      ASSERT_TRUE(solution.status.ok()) << solution.status.message;
      EXPECT_LT(worstConstraint(problem, solution.theta), 1e-11);
      EXPECT_LT(unexplainedGradient(problem, solution.theta), 1e-9);
      EXPECT_NEAR(solution.objective, angleObjective(problem, solution.theta), 1e-15);
    }
    EXPECT_LT(largestDifference(newton.theta, sequential.theta), 1e-9);
    EXPECT_NEAR(newton.objective, sequential.objective, 1e-12 + 1e-10 * newton.objective);
  }
}

TEST(AngleSolver, NewtonConvergesQuadraticallyInAFewSteps)
{
  for (const Surface& surface : curvedSurfaces())
  {
    const AngleSolution solution = WiredSurface(surface).solve();
    EXPECT_LE(solution.iterations, 8);
    EXPECT_GT(solution.iterations, 0);
    EXPECT_GE(static_cast<int>(solution.history.size()), solution.iterations);
    EXPECT_LT(solution.history.back().optimality, 1e-10);
    // Each step squares what is missing, up to a constant.
    int squared = 0;
    for (std::size_t k = 0; k + 1 < solution.history.size(); ++k)
    {
      const double before = solution.history[k].optimality;
      if (before < 0.02 && before > 1e-7)
      {
        EXPECT_LT(solution.history[k + 1].optimality, 30.0 * before * before + 1e-13);
        ++squared;
      }
    }
    EXPECT_GE(squared, 1);
  }
}

TEST(AngleSolver, AWideBandFindsTheLengthWhoseSensitivityIsItsCost)
{
  // Free to choose, the stretch h ends where dF/dh + w h = 0; sensitivity is dF/dl.
  const WiredSurface wired(quarterSphere());
  AngleProblem problem = wired.problem();
  const double weight = 0.5;
  problem.groups = { { 0.5, weight } };
  for (Index e = 0; e < wired.network.edgeCount(); ++e)
  {
    problem.stretchGroup[e] = wired.network.edges[e].curve == 0 ? 0 : none;
  }
  const AngleSolution elastic = solve(problem, AngleMethod::Newton);
  ASSERT_LT(std::abs(elastic.stretch[0]), 0.5);
  ASSERT_GT(std::abs(elastic.stretch[0]), 1e-3);
  AngleProblem rigid = wired.problem();
  rigid.length = elastic.length;
  const AngleSolution again = solve(rigid, AngleMethod::Newton);
  EXPECT_LT(largestDifference(again.theta, elastic.theta), 1e-9);
  const std::vector<double> sensitivity = lengthSensitivity(wired.network, again);
  double slope = weight * elastic.stretch[0];
  for (Index e = 0; e < wired.network.edgeCount(); ++e)
  {
    slope += problem.stretchGroup[e] == 0 ? sensitivity[e] * problem.length[e] : 0.0;
  }
  EXPECT_NEAR(slope, 0.0, 1e-9);
}

namespace
{
Eigen::VectorXd randomVector(Eigen::Index size, double scale)
{
  std::mt19937 random(11);
  Eigen::VectorXd x(size);
  for (double& value : x)
  {
    value = scale * (random() / 2147483648.0 - 1.0);
  }
  return x;
}

/// Several patches, a key curve, a hole joined by connectors, a dangling wire; two elastic groups.
struct Everything
{
  WiredSurface wired;
  AngleProblem problem;

  Everything()
    : wired(surface())
    , problem(wired.problem())
  {
    problem.groups = { { 0.1, 0.02 }, { 0.9, 0.05 } };
    for (Index e = 0; e < wired.network.edgeCount(); ++e)
    {
      const WireEdge& edge = wired.network.edges[e];
      problem.stretchGroup[e] = edge.connector ? 1 : edge.curve == 1 ? 0 : none;
    }
  }

  static Surface surface()
  {
    return withCurves(cushion(8, 8, 0.5),
      { curveOf(CurveType::Key, "key", rowCurve(8, 6).vertices), columnCurve(8, 8, 2),
        accessory("dangling", { 7, 16 }), curveOf(CurveType::Dart, "eye", { 22, 31, 40 }) });
  }

  /// A point near the surface's angles, with some stretch.
  Eigen::VectorXd point(const DirectionsForm& form) const
  {
    return form.unknowns(form.projectedAngles()) + randomVector(form.unknownCount(), 0.1);
  }
};

std::vector<double> shaken(std::vector<double> theta, const NodeLocks& locks)
{
  std::mt19937 random(7);
  for (std::size_t i = 0; i < theta.size(); ++i)
  {
    theta[i] += locks.locked[i] ? 0.0 : 0.2 * (random() / 4294967296.0 - 0.5);
  }
  return theta;
}
}

TEST(AngleProblem, TheJacobianIsTheDerivativeOfTheResidual)
{
  for (const Surface& surface : { quarterSphere(), Everything::surface() })
  {
    const WiredSurface wired(surface);
    const AngleProblem problem = wired.problem();
    const AngleConstraints constraints(problem);
    const std::vector<double> theta = shaken(problem.locks.angle, problem.locks);
    const Eigen::MatrixXd jacobian(constraints.jacobian(theta));
    const double step = 1e-5;
    for (Index k = 0; k < constraints.freeCount(); ++k)
    {
      std::vector<double> forward = theta;
      std::vector<double> backward = theta;
      forward[constraints.freeNodes()[k]] += step;
      backward[constraints.freeNodes()[k]] -= step;
      const Eigen::VectorXd difference =
        (constraints.residual(forward) - constraints.residual(backward)) / (2.0 * step);
      EXPECT_LT((jacobian.col(k) - difference).cwiseAbs().maxCoeff(), 1e-8) << "column " << k;
    }
  }
}

TEST(DirectionsForm, TheKktMatrixHoldsTheDerivativesOfObjectiveClosureAndLagrangian)
{
  const Everything all;
  const DirectionsForm form(all.problem);
  const Eigen::VectorXd x = all.point(form);
  const Eigen::VectorXd multipliers = randomVector(form.constraintCount(), 1.0);
  DirectionsKkt kkt(form);
  expectGradientOfObjective(kkt, x, 1e-5, 1e-8);
  expectKktOfLagrangian(kkt, x, multipliers, 1e-5, 1e-8, 1e-8);
  kkt.linearize(x, multipliers, Curvature::Exact, 0.25);
  const Eigen::MatrixXd matrix(Eigen::MatrixXd(kkt.kkt()).selfadjointView<Eigen::Lower>());
  const Eigen::MatrixXd corner = matrix.bottomRightCorner(multipliers.size(), multipliers.size());
  EXPECT_EQ(corner, -0.25 * Eigen::MatrixXd::Identity(multipliers.size(), multipliers.size()));
  const Eigen::VectorXd product =
    matrix.topRightCorner(form.unknownCount(), multipliers.size()) * multipliers;
  EXPECT_LT((product - kkt.transposedJacobianTimes(multipliers)).cwiseAbs().maxCoeff(), 1e-12);
}

namespace
{
ProgressiveSolution warp(const WiredSurface& wired)
{
  return warpProgressively(wired.problem(), {}, {});
}

/// Four wire-patches in a row from y = 0 up.
Surface fourBands()
{
  return withCurves(cushion(4, 8, 0.2), { rowCurve(4, 2), rowCurve(4, 4), rowCurve(4, 6) });
}
}

TEST(ProgressiveWarping, StartsAtKeysAndGoesOnToTheLargestEvidence)
{
  // 12 nodes a patch. The key locks 5 of patches 2 and 3; patch 2 then gives 3 nodes to patch 1,
  // which is fewer than the 5 of patch 3.
  Surface surface = fourBands();
  surface.curves[2].type = CurveType::Key;
  const ProgressiveSolution solution = warp(WiredSurface(surface));
  ASSERT_TRUE(solution.angles.status.ok());
  EXPECT_EQ(solution.warpingOrder, (Indices{ 2, 3, 1, 0 }));
}

TEST(ProgressiveWarping, WithoutKeysStartsAtTheFirstPatchAndWalksToItsNeighbours)
{
  EXPECT_EQ(warp(WiredSurface(fourBands())).warpingOrder, (Indices{ 0, 1, 2, 3 }));
  // A cross: the patches beside the first one know three nodes each, the one across none.
  Surface cross = withCurves(cushion(4, 4, 0.2), { rowCurve(4, 2), columnCurve(4, 4, 2) });
  const ProgressiveSolution solution = warp(WiredSurface(cross));
  EXPECT_EQ(solution.warpingOrder, (Indices{ 0, 1, 2, 3 }));
}

TEST(ProgressiveWarping, TheFirstPatchIsFlattenedAsIfItWereAlone)
{
  Surface surface = quarterSphere();
  const WiredSurface whole(surface);
  const ProgressiveSolution solution = warp(whole);
  EXPECT_TRUE(solution.closes());
  surface.curves[0].type = CurveType::Seam;
  const WiredSurface alone(surface); // the first of its two pieces
  const AngleSolution single = alone.solve();
  ASSERT_EQ(alone.network.nodeCount(), whole.network.loopBegin[1]);
  for (Index i = 0; i < alone.network.nodeCount(); ++i)
  {
    const Index vertex = alone.original(alone.network.vertex[i]);
    for (Index k = 0; k < whole.network.loopBegin[1]; ++k)
    {
      if (whole.original(whole.network.vertex[k]) == vertex)
      {
        EXPECT_NEAR(solution.angles.theta[k], single.theta[i], 1e-10);
      }
    }
  }
}

TEST(ProgressiveWarping, OfASinglePatchIsTheGlobalOptimum)
{
  Surface plain = cushion(8, 6, 0.4);
  Surface dart = withCurves(plain, { curveOf(CurveType::Dart, "dart", { 4, 13, 22 }) });
  Surface dangling = withCurves(plain, { accessory("dangling", { 4, 13, 22, 31 }) });
  for (const Surface& surface : { plain, dart, dangling })
  {
    const WiredSurface wired(surface);
    ASSERT_EQ(wired.network.loopCount(), 1);
    const ProgressiveSolution solution = warp(wired);
    ASSERT_TRUE(solution.angles.status.ok());
    EXPECT_LT(largestDifference(solution.angles.theta, wired.solve().theta), 1e-9);
  }
}

namespace
{
struct Release
{
  Indices released;
  int solves = 0;
};

/// What the search makes of a number of keys and a solver that succeeds where `works` says so of
/// the released ones, with the objective that `cost` gives.
template <class Works, class Cost>
Release release(Index count, Works works, Cost cost)
{
  Indices keys(count);
  std::iota(keys.begin(), keys.end(), 0);
  Release result;
  std::set<Indices> asked;
  const auto solve = [&](const Indices& next) -> std::optional<double> {
    EXPECT_TRUE(asked.insert(next).second) << "solved the same trial twice";
    const std::set<Index> released(next.begin(), next.end());
    ++result.solves;
    return works(released) ? std::optional<double>(cost(released)) : std::nullopt;
  };
  result.released = releaseKeys(keys, solve).released;
  return result;
}

double one(const std::set<Index>&)
{
  return 1.0;
}
}

TEST(KeyRelease, ReleasesTheFewestAndOfAsManyThoseOfTheLeastObjective)
{
  using Keys = std::set<Index>;
  struct Case
  {
    Index count;
    std::function<bool(const Keys&)> works;
    std::function<double(const Keys&)> cost;
    Indices released;
    int solves = 1000000;
  };
  const std::vector<Case> cases{
    { 5, [](const Keys&) { return true; }, [](const Keys& r) { return std::abs(*r.begin() - 2.2); },
      { 2 } },
    { 5, [](const Keys& r) { return r.count(0) && r.count(4); }, one, { 0, 4 } },
    { 5, [](const Keys& r) { return r.size() == 5; }, one, { 0, 1, 2, 3, 4 } },
    { 5, [](const Keys&) { return false; }, one, {} },
    // One of each of three pairs that clash.
    { 20,
      [](const Keys& r) {
        return (r.count(2) || r.count(11)) && (r.count(5) || r.count(6)) &&
          (r.count(14) || r.count(19));
      },
      [](const Keys& r) {
        return 10.0 - (r.count(11) ? 1.0 : 0.0) - (r.count(5) ? 2.0 : 0.0) -
          (r.count(19) ? 3.0 : 0.0);
      },
      { 5, 11, 19 } },
    // The innocent are left alone however many there are.
    { 40, [](const Keys& r) { return r.count(3) && r.count(17) && r.count(18) && r.count(39); },
      one, { 3, 17, 18, 39 }, 100 },
    // One that clashes with four others.
    { 20,
      [](const Keys& r) {
        return r.count(7) || (r.count(1) && r.count(4) && r.count(12) && r.count(16));
      },
      one, { 7 } },
  };
  for (const Case& c : cases)
  {
    const Release result = release(c.count, c.works, c.cost);
    EXPECT_EQ(result.released, c.released);
    EXPECT_LT(result.solves, c.solves);
  }
}

TEST(KeyRelease, WhereAlmostAllClashNoneOfTheReleasedCanBeKept)
{
  const Release result = release(
    20, [](const std::set<Index>& r) { return r.size() >= 12; }, one);
  EXPECT_EQ(result.released.size(), 12u);
  EXPECT_LT(result.solves, 200);
}

TEST(ReleaseAdvice, SensitivityIsTheChangeOfTheOptimumWhenACurveGrows)
{
  const WiredSurface wired(
    withCurves(cushion(6, 8, 0.3), { columnCurve(6, 8, 3), rowCurve(6, 4) }));
  const ReleaseAdvice advice = adviseRelease(wired.network, wired.curves, wired.solve());
  for (Index curve = 0; curve < 2; ++curve)
  {
    const auto optimum = [&](double factor) {
      AngleProblem problem = wired.problem();
      for (Index e = 0; e < wired.network.edgeCount(); ++e)
      {
        if (wired.network.edges[e].curve == curve)
        {
          problem.length[e] *= factor;
        }
      }
      return solveAnglesByNewton(problem, {}, {}).objective;
    };
    const double step = 1e-5;
    const double slope = (optimum(1.0 + step) - optimum(1.0 - step)) / (2.0 * step);
    EXPECT_NEAR(advice.sensitivity[curve], slope, 1e-4 * (1.0 + std::abs(slope)));
  }
}

TEST(ReleaseAdvice, IsSilentWhereTheSolutionIsGood)
{
  const Surface surface = quarterSphere();
  const FlatteningResult result = flatten(surface);
  EXPECT_FALSE(result.pieces[0].advice.first().solved);
}
