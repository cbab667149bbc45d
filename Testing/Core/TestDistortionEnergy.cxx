// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/DistortionEnergy.h"

#include "ModelDerivatives.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Random maps that turn nothing over, as parts (q, p).
std::vector<Eigen::Vector4d> sampleParts()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Eigen::Vector4d> samples;
  while (samples.size() < 50)
  {
    Eigen::Vector4d parts;
    parts << 2.0 * uniform(random), 2.0 * uniform(random), uniform(random), uniform(random);
    if (parts.head<2>().norm() > parts.tail<2>().norm() + 0.2)
    {
      samples.push_back(parts);
    }
  }
  return samples;
}

Eigen::Matrix2d matrixOf(const Eigen::Vector4d& parts)
{
  Eigen::Matrix2d J;
  J << 0.5 * (parts[0] + parts[2]), 0.5 * (parts[3] - parts[1]), 0.5 * (parts[1] + parts[3]),
    0.5 * (parts[0] - parts[2]);
  return J;
}

std::vector<DistortionEnergy> allEnergies()
{
  return { { DistortionEnergyKind::AsRigidAsPossible, 0.0 },
    { DistortionEnergyKind::AsRigidAsPossible, 0.6 },
    { DistortionEnergyKind::AsRigidAsPossible, -0.6 },
    { DistortionEnergyKind::SymmetricDirichlet, 0.0 } };
}
}

TEST(DistortionEnergy, IsTheDistanceToTheNearestRotation)
{
  for (const Eigen::Vector4d& parts : sampleParts())
  {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(
      Eigen::MatrixXd(matrixOf(parts)), Eigen::ComputeThinU | Eigen::ComputeThinV);
    const double expected = (svd.singularValues().array() - 1.0).square().sum();
    EXPECT_NEAR(distortionEnergyDensity({}, parts), expected, 1e-13);
  }
}

TEST(DistortionEnergy, SymmetricDirichletIsTheNormOfTheMapAndOfItsInverse)
{
  const DistortionEnergy energy{ DistortionEnergyKind::SymmetricDirichlet, 0.0 };
  for (const Eigen::Vector4d& parts : sampleParts())
  {
    const Eigen::Matrix2d J = matrixOf(parts);
    const double expected = J.squaredNorm() + J.inverse().squaredNorm() - 4.0;
    EXPECT_NEAR(distortionEnergyDensity(energy, parts), expected, 1e-10 * (1.0 + expected));
  }
  EXPECT_TRUE(std::isinf(distortionEnergyDensity(energy, { 0.5, 0.0, 1.0, 0.0 })));
}

TEST(DistortionEnergy, ABiasWeighsAreaAgainstAngle)
{
  const Eigen::Vector4d larger(2.2, 0.0, 0.0, 0.0);  // both stretches 1.1
  const Eigen::Vector4d sheared(2.0, 0.0, 0.2, 0.0); // stretches 1.1 and 0.9
  const DistortionEnergy stiff{ DistortionEnergyKind::AsRigidAsPossible, 0.5 };
  const DistortionEnergy stretchy{ DistortionEnergyKind::AsRigidAsPossible, -0.5 };
  EXPECT_NEAR(distortionEnergyDensity(stiff, larger), 0.03, 1e-15);
  EXPECT_NEAR(distortionEnergyDensity(stiff, sheared), 0.01, 1e-15);
  EXPECT_NEAR(distortionEnergyDensity(stretchy, larger), 0.01, 1e-15);
  EXPECT_NEAR(distortionEnergyDensity(stretchy, sheared), 0.03, 1e-15);
}

TEST(DistortionEnergy, GradientAndHessianAreThoseOfFiniteDifferences)
{
  for (const DistortionEnergy& energy : allEnergies())
  {
    const auto evaluate = [&energy](const Eigen::Vector4d& parts) {
      return evaluateDistortionEnergy(energy, parts, false);
    };
    for (const Eigen::Vector4d& parts : sampleParts())
    {
      const DistortionEnergyValue value = evaluate(parts);
      EXPECT_NEAR(value.value, distortionEnergyDensity(energy, parts), 1e-12 * (1.0 + value.value));
      const double scale = 1.0 + value.hessian.cwiseAbs().maxCoeff();
      expectDensityDerivatives(evaluate, parts, 1e-5, 1e-5, 1e-6 * scale * scale);
    }
  }
}

TEST(DistortionEnergy, TheConvexHessianIsTheExactOneWithoutItsNegativeEigenvalues)
{
  for (const DistortionEnergy& energy : allEnergies())
  {
    for (const Eigen::Vector4d& parts : sampleParts())
    {
      const Eigen::Matrix4d exact = evaluateDistortionEnergy(energy, parts, false).hessian;
      const Eigen::Matrix4d convex = evaluateDistortionEnergy(energy, parts, true).hessian;
      EXPECT_LT((convex - nearestConvex(exact)).norm(), 1e-10 * (1.0 + exact.norm()));
    }
  }
}
