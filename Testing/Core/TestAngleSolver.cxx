// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/AngleProblem.h"
#include "Angles/AngleSolver.h"
#include "Angles/DirectionsForm.h"
#include "ModelDerivatives.h"
#include "Reference/SequentialAngleSolver.h"
#include "WiredSurface.h"

#include <Eigen/QR>
#include <Eigen/SparseCholesky>

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

TEST(AngleSolver, SaysWhenItRanOutOfIterations)
{
  const WiredSurface wired(quarterSphere());
  for (const AngleMethod method : { AngleMethod::Newton, AngleMethod::Sequential })
  {
    for (const int most : { 0, 2 })
    {
      AngleSolverOptions options;
      options.method = method;
      options.maximumIterations = most;
      const AngleSolution solution = solveAngles(wired.problem(), options, {});
      EXPECT_STREQ(statusName(solution.status.code), "NotConverged");
      EXPECT_FALSE(solution.status.refused());
      EXPECT_EQ(solution.iterations, most);
      EXPECT_EQ(solution.theta.size(), 24U);
    }
  }
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
    Surface surface = cushion(8, 8, 0.5);
    surface.curves = { curveOf(CurveType::Key, "key", rowCurve(8, 6).vertices),
      columnCurve(8, 8, 2), accessory("dangling", { 7, 16 }),
      curveOf(CurveType::Dart, "eye", { 22, 31, 40 }) };
    return surface;
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

TEST(DirectionsForm, ProjectedAnglesAreTheNearestThatMeetTheLinearConstraints)
{
  const WiredSurface wired(quarterSphere());
  const AngleProblem problem = wired.problem();
  const DirectionsForm form(problem);
  const std::vector<double>& projected = form.projectedAngles();
  // The gradient of the distance vanishes over all angles that the form can make.
  const Eigen::VectorXd x = form.unknowns(projected);
  EXPECT_LT(largestDifference(form.angles(x), projected), 1e-12);
  EXPECT_LT(form.gradient(x).cwiseAbs().maxCoeff(), 1e-12);
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
