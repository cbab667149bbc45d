// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/WireLayout.h"
#include "Isometric/IsometricModel.h"
#include "ModelDerivatives.h"
#include "WiredSurface.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A cushion with a key, an elastic and a rigid curve, a little away from its flat layout.
struct Example
{
  Surface surface;
  WiredSurface wired;
  AngleProblem problem;

  Example()
    : surface(makeSurface())
    , wired(surface)
    , problem(wired.problem())
  {
    this->problem.groups.push_back({ 0.05, 0.1 });
    for (Index e = 0; e < this->wired.network.edgeCount(); ++e)
    {
      if (this->wired.network.edges[e].curve == 1)
      {
        this->problem.stretchGroup[e] = 0;
      }
    }
  }

  static Surface makeSurface()
  {
    Surface result = cushion(6, 8, 0.25);
    result.curves = { columnCurve(6, 8, 3, CurveType::Key), rowCurve(6, 3), rowCurve(6, 6) };
    return result;
  }

  static Eigen::VectorXd multipliers(const IsometricModel& model)
  {
    Eigen::VectorXd result(model.constraintCount());
    for (Index k = 0; k < result.size(); ++k)
    {
      result[k] = std::sin(1.7 * k);
    }
    return result;
  }

  Eigen::VectorXd point(const IsometricModel& model) const
  {
    Points2 positions;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.01, 0.01);
    for (const Point3& p : this->wired.piece.mesh.points())
    {
      positions.emplace_back(p.x() + uniform(random), p.y() + uniform(random));
    }
    return model.unknowns(positions, { 0.01 });
  }
};

std::vector<DistortionEnergy> energies()
{
  return { { DistortionEnergyKind::AsRigidAsPossible, 0.3 },
    { DistortionEnergyKind::SymmetricDirichlet, 0.0 } };
}
}

TEST(IsometricModel, DerivativesWithoutTheMatrixAreThoseBesideIt)
{
  const Example example;
  for (const DistortionEnergy& energy : energies())
  {
    IsometricModel model(example.wired.piece, example.problem, energy, 5.0);
    const Eigen::VectorXd x = example.point(model);
    const Eigen::VectorXd away = 1.1 * x;
    const Eigen::VectorXd multipliers = Example::multipliers(model);
    const auto linear = model.linearize(x, multipliers, Curvature::Exact, 0.0, {});
    const Eigen::VectorXd forces = model.transposedJacobianTimes(multipliers);
    model.linearize(away, multipliers, Curvature::Exact, 0.0, {});
    const SparseMatrix matrix = model.kkt();
    const auto alone = model.differentiate(x, {});
    ASSERT_TRUE(alone.has_value());
    EXPECT_LT((alone->gradient - linear.gradient).norm(), 1e-13 * linear.gradient.norm());
    EXPECT_EQ(alone->constraints, linear.constraints);
    EXPECT_LT((model.transposedJacobianTimes(multipliers) - forces).norm(), 1e-13 * forces.norm());
    EXPECT_EQ((model.kkt() - matrix).norm(), 0.0);
  }
}

TEST(IsometricModel, DerivativesAreThoseOfFiniteDifferences)
{
  const Example example;
  for (const DistortionEnergy& energy : energies())
  {
    IsometricModel model(example.wired.piece, example.problem, energy, 5.0);
    const Eigen::VectorXd x = example.point(model);
    const Eigen::VectorXd multipliers = Example::multipliers(model);
    expectGradientOfObjective(model, x, 1e-6, 1e-5);
    // What takes out the rigid motions is no derivative.
    const std::array<Index, 2> fixed = model.fixedVertices();
    expectKktOfLagrangian(model, x, multipliers, 1e-6, 1e-4, 1e-6,
      [&fixed](Index k) { return k / 2 == fixed[0] || k / 2 == fixed[1]; });
  }
}

TEST(IsometricModel, KnowsWhatTheRoundingOfPositionsLeavesOfTheGradient)
{
  const Example example;
  IsometricModel model(example.wired.piece, example.problem, {}, 5.0);
  // Far from the origin rounding is large; a stiff wire feels it most.
  Eigen::VectorXd x = example.point(model);
  x.head(model.coordinateCount()).array() += 1e6;
  const Eigen::VectorXd gradient = model.differentiate(x, {})->gradient;
  Eigen::VectorXd rounded = x;
  for (Index k = 0; k < model.coordinateCount(); ++k)
  {
    rounded[k] = std::nextafter(x[k], k % 3 == 0 ? 0.0 : 2e6);
  }
  const double moved =
    (model.differentiate(rounded, {})->gradient - gradient).cwiseAbs().maxCoeff();
  EXPECT_LT(moved, 10.0 * model.gradientRounding(x));
  EXPECT_GT(moved, 0.1 * model.gradientRounding(x));
}
