// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/DirectionsForm.h"
#include "WiredSurface.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <random>

using namespace flattening;
using namespace testmeshes;

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
}

TEST(DirectionsForm, EveryPointMeetsTheTurningAndWholeTurnConstraints)
{
  Surface surface = cushion(8, 8, 0.5);
  surface.curves = { rowCurve(8, 6), columnCurve(8, 8, 2), accessory("dangling", { 7, 16 }),
    curveOf(CurveType::Dart, "eye", { 22, 31, 40 }) };
  const WiredSurface wired(surface);
  const AngleProblem problem = wired.problem();
  const DirectionsForm form(problem);
  const AngleConstraints constraints(problem);
  const Eigen::VectorXd x = randomVector(form.unknownCount(), 2.0);
  const Eigen::VectorXd residual = constraints.residual(form.angles(x));
  for (Index loop = 0; loop < wired.network.loopCount(); ++loop)
  {
    EXPECT_NEAR(residual[3 * loop], 0.0, 1e-12);
  }
  for (Index row = 3 * wired.network.loopCount(); row < constraints.rowCount(); ++row)
  {
    EXPECT_NEAR(residual[row], 0.0, 1e-12);
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

TEST(DirectionsForm, TheGradientIsTheDerivativeOfTheObjective)
{
  const Everything all;
  const DirectionsForm form(all.problem);
  const Eigen::VectorXd x = all.point(form);
  const Eigen::VectorXd gradient = form.gradient(x);
  const double step = 1e-5;
  for (Index k = 0; k < form.unknownCount(); ++k)
  {
    const Eigen::VectorXd e = step * Eigen::VectorXd::Unit(form.unknownCount(), k);
    const double difference = (form.objective(x + e) - form.objective(x - e)) / (2.0 * step);
    EXPECT_NEAR(gradient[k], difference, 1e-8) << "unknown " << k;
  }
}

TEST(DirectionsForm, TheKktMatrixHoldsTheDerivativesOfClosureAndLagrangian)
{
  const Everything all;
  const DirectionsForm form(all.problem);
  const Eigen::VectorXd x = all.point(form);
  const Eigen::VectorXd multipliers = randomVector(form.constraintCount(), 1.0);
  const Index unknowns = form.unknownCount();
  DirectionsKkt kkt(form);
  const auto slope = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    const auto linear = kkt.linearize(at, multipliers, Curvature::Exact, 0.25);
    return linear.gradient + kkt.transposedJacobianTimes(multipliers);
  };
  kkt.linearize(x, multipliers, Curvature::Exact, 0.25);
  const Eigen::VectorXd jacobianProduct = kkt.transposedJacobianTimes(multipliers);
  const Eigen::MatrixXd matrix(Eigen::MatrixXd(kkt.kkt()).selfadjointView<Eigen::Lower>());
  const double step = 1e-5;
  for (Index k = 0; k < unknowns; ++k)
  {
    const Eigen::VectorXd e = step * Eigen::VectorXd::Unit(unknowns, k);
    const Eigen::VectorXd closure = (form.closure(x + e) - form.closure(x - e)) / (2.0 * step);
    EXPECT_LT((matrix.col(k).tail(closure.size()) - closure).cwiseAbs().maxCoeff(), 1e-8) << k;
    const Eigen::VectorXd curvature = (slope(x + e) - slope(x - e)) / (2.0 * step);
    EXPECT_LT((matrix.col(k).head(unknowns) - curvature).cwiseAbs().maxCoeff(), 1e-8) << k;
  }
  const Eigen::MatrixXd corner = matrix.bottomRightCorner(multipliers.size(), multipliers.size());
  EXPECT_EQ(corner, -0.25 * Eigen::MatrixXd::Identity(multipliers.size(), multipliers.size()));
  const Eigen::VectorXd product = matrix.topRightCorner(unknowns, multipliers.size()) * multipliers;
  EXPECT_LT((product - jacobianProduct).cwiseAbs().maxCoeff(), 1e-12);
}
