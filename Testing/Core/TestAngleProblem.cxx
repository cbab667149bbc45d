// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/AngleProblem.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
std::vector<double> shaken(std::vector<double> theta, const NodeLocks& locks)
{
  std::mt19937 random(7);
  for (std::size_t i = 0; i < theta.size(); ++i)
  {
    theta[i] += locks.locked[i] ? 0.0 : 0.2 * (random() / 4294967296.0 - 0.5);
  }
  return theta;
}

/// Surfaces with every kind of loop: several patches, locked nodes, a hole, a dangling wire.
std::vector<Surface> wiredSurfaces()
{
  std::vector<Surface> surfaces;
  surfaces.push_back(quarterSphere());
  Surface keys = cushion(6, 6, 0.5);
  keys.curves = { curveOf(CurveType::Key, "key", rowCurve(6, 3).vertices), columnCurve(6, 6, 2) };
  surfaces.push_back(keys);
  Surface hole = cushion(6, 6, 0.5);
  hole.curves = { curveOf(CurveType::Dart, "eye", { 16, 23, 30 }),
    accessory("dangling", { 3, 10 }) };
  surfaces.push_back(hole);
  return surfaces;
}
}

TEST(AngleProblem, AllConstraintsHoldForTheAnglesOfAFlatSurface)
{
  Surface surface = flatPatch(6, 6);
  surface.curves = { rowCurve(6, 2), columnCurve(6, 6, 4), accessory("dangling", { 3, 10 }),
    curveOf(CurveType::Dart, "eye", { 29, 30, 31 }) };
  const WiredSurface wired(surface);
  const AngleProblem problem = wired.problem();
  const AngleConstraints constraints(problem);
  EXPECT_LT(constraints.residual(wired.network.alpha).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(closureResidual(wired.network, wired.network.alpha, problem.length), 1e-12);
  EXPECT_DOUBLE_EQ(angleObjective(problem, wired.network.alpha), 0.0);
}

TEST(AngleProblem, TheJacobianIsTheDerivativeOfTheResidual)
{
  for (const Surface& surface : wiredSurfaces())
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
