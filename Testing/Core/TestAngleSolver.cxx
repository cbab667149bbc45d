// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/AngleSolver.h"
#include "Reference/SequentialAngleSolver.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

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
  std::vector<Surface> surfaces;
  Surface crossing = cushion(8, 6, 0.15);
  crossing.curves = { rowCurve(8, 2), rowCurve(8, 4), columnCurve(8, 6, 3) };
  surfaces.push_back(crossing);
  Surface key = crossing;
  key.curves[1].type = CurveType::Key;
  surfaces.push_back(key);
  Surface straight = key;
  straight.curves[1].keyShape = KeyShape::Straight;
  surfaces.push_back(straight);
  Surface dart = cushion(8, 6, 0.15);
  dart.curves = { curveOf(CurveType::Dart, "dart", { 4, 13, 22 }), rowCurve(8, 4),
    accessory("to the dart", { 9, 10, 11, 12, 13 }) };
  surfaces.push_back(dart);
  Surface dangling = cushion(8, 6, 0.15);
  dangling.curves = { accessory("dangling", { 4, 13, 22, 31 }) };
  surfaces.push_back(dangling);
  surfaces.push_back(quarterSphere());
  return surfaces;
}
}

TEST(AngleSolver, NewtonAndSequentialAgree)
{
  for (const Surface& surface : curvedSurfaces())
  {
    const WiredSurface wired(surface);
    const AngleSolution newton = wired.solve(AngleMethod::Newton);
    const AngleSolution sequential = wired.solve(AngleMethod::Sequential);
    ASSERT_TRUE(newton.status.ok()) << newton.status.message;
    ASSERT_TRUE(sequential.status.ok()) << sequential.status.message;
    EXPECT_LT(largestDifference(newton.theta, sequential.theta), 1e-9);
    EXPECT_NEAR(newton.objective, sequential.objective, 1e-12 + 1e-10 * newton.objective);
  }
}

TEST(AngleSolver, SolutionsMeetTheConstraintsAndAreStationary)
{
  for (const Surface& surface : curvedSurfaces())
  {
    const WiredSurface wired(surface);
    const AngleProblem problem = wired.problem();
    for (const AngleMethod method : { AngleMethod::Newton, AngleMethod::Sequential })
    {
      const AngleSolution solution = solve(problem, method);
      EXPECT_LT(worstConstraint(problem, solution.theta), 1e-11);
      EXPECT_LT(unexplainedGradient(problem, solution.theta), 1e-9);
      EXPECT_NEAR(solution.objective, angleObjective(problem, solution.theta), 1e-15);
    }
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
