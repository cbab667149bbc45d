// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/DistortionEnergy.h"
#include "Sewing/SheetDensity.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <random>

using namespace flattening;

namespace
{
/// Maps of the plane to itself that turn nothing over.
std::vector<Eigen::Matrix2d> planarMaps()
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Eigen::Matrix2d> maps;
  while (maps.size() < 50)
  {
    Eigen::Matrix2d map;
    map << uniform(random), uniform(random), uniform(random), uniform(random);
    if (map.determinant() > 0.05)
    {
      maps.push_back(map);
    }
  }
  return maps;
}

Eigen::Vector3d metric(const Eigen::Matrix2d& map)
{
  return { map.col(0).squaredNorm(), map.col(1).squaredNorm(), map.col(0).dot(map.col(1)) };
}
}

TEST(MetricDensity, IsThatOfTheFlatteningInThePlane)
{
  for (const double bias : { -0.5, 0.0, 0.4 })
  {
    for (const Eigen::Matrix2d& map : planarMaps())
    {
      const Eigen::Vector4d parts(
        map(0, 0) + map(1, 1), map(1, 0) - map(0, 1), map(0, 0) - map(1, 1), map(1, 0) + map(0, 1));
      const double planar =
        distortionEnergyDensity({ DistortionEnergyKind::AsRigidAsPossible, bias }, parts);
      EXPECT_NEAR(isotropicDensity(bias, metric(map)), planar, 1e-13 * (1.0 + planar));
    }
  }
}

TEST(MetricDensity, KeepsItsDigitsWhereLittleIsStrained)
{
  // A strain of e in one direction costs e^2, however small.
  for (const double strain : { 1e-3, 1e-6, 1e-9 })
  {
    const Eigen::Vector3d stretched((1.0 + strain) * (1.0 + strain), 1.0, 0.0);
    EXPECT_NEAR(isotropicDensity(0.0, stretched) / (strain * strain), 1.0, 1e-6);
  }
}

TEST(MetricDensity, DerivativesAreThoseOfFiniteDifferences)
{
  const double step = 1e-5;
  for (const double bias : { -0.5, 0.0, 0.4 })
  {
    for (const Eigen::Matrix2d& map : planarMaps())
    {
      const Eigen::Vector3d at = metric(map);
      const MetricDensity density = evaluateIsotropicDensity(bias, at);
      EXPECT_DOUBLE_EQ(density.value, isotropicDensity(bias, at));
      // Third derivatives grow where a map is nearly collapsed.
      const double scale = 1.0 / std::pow(map.determinant(), 5.0);
      for (int k = 0; k < 3; ++k)
      {
        const Eigen::Vector3d move = step * Eigen::Vector3d::Unit(k);
        const MetricDensity up = evaluateIsotropicDensity(bias, at + 0.01 * move);
        const MetricDensity down = evaluateIsotropicDensity(bias, at - 0.01 * move);
        EXPECT_NEAR(density.gradient[k], (up.value - down.value) / (0.02 * step), 1e-8 * scale);
        const Eigen::Vector3d bend = (up.gradient - down.gradient) / (0.02 * step);
        EXPECT_LT((density.hessian.col(k) - bend).norm(), 1e-6 * scale);
      }
    }
  }
}

TEST(MetricDensity, IsConvexInTheMetricWithoutBias)
{
  for (const Eigen::Matrix2d& map : planarMaps())
  {
    const MetricDensity density = evaluateIsotropicDensity(0.0, metric(map));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(density.hessian);
    EXPECT_GT(solver.eigenvalues()[0], -1e-12 * solver.eigenvalues()[2]);
  }
}
