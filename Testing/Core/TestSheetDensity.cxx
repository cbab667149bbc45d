// SPDX-License-Identifier: BSD-3-Clause
#include "Cloth/ClothMaterial.h"
#include "Embedding/DistortionEnergy.h"
#include "Sewing/SheetDensity.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <random>

using namespace flattening;

namespace
{
/// The metric of a map that stretches weft and warp and shears them.
Eigen::Vector3d metricOf(double warp, double weft, double shear)
{
  return { (1.0 + weft) * (1.0 + weft), (1.0 + warp) * (1.0 + warp),
    (1.0 + weft) * (1.0 + warp) * std::sin(shear) };
}

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

Eigen::Vector3d metricOf(const Eigen::Matrix2d& map)
{
  return { map.col(0).squaredNorm(), map.col(1).squaredNorm(), map.col(0).dot(map.col(1)) };
}
}

TEST(SheetDensity, AThreadThatIsDrawnAloneCostsItsStiffnessAndSoDoesShear)
{
  ClothMaterial cloth;
  cloth.warp = 400.0;
  cloth.weft = 1000.0;
  cloth.shear = 30.0;
  const SheetDensity sheet(cloth);
  // In units in which the stiffer thread has 2.
  EXPECT_NEAR(sheet.value(metricOf(0.02, 0.0, 0.0)), 0.5 * 0.8 * 0.02 * 0.02, 1e-15);
  EXPECT_NEAR(sheet.value(metricOf(0.0, -0.02, 0.0)), 0.5 * 2.0 * 0.02 * 0.02, 1e-15);
  EXPECT_NEAR(sheet.value(metricOf(0.0, 0.0, 0.3)), 0.5 * 0.06 * 0.3 * 0.3, 1e-15);
  EXPECT_EQ(sheet.value(metricOf(0.0, 0.0, 0.0)), 0.0);
}

TEST(SheetDensity, AClothAlikeInAllDirectionsIsTheIsotropicSheetForSmallStrains)
{
  ClothMaterial cloth;
  cloth.warp = cloth.weft = 2.0;
  cloth.shear = 1.0;
  const SheetDensity woven(cloth);
  const SheetDensity sheet(0.0);
  const auto difference = [&](double size) {
    const Eigen::Vector3d metric = metricOf(0.7 * size, -0.4 * size, 0.9 * size);
    return std::abs(woven.value(metric) - sheet.value(metric)) / sheet.value(metric);
  };
  EXPECT_LT(difference(1e-3), 2e-3);
  EXPECT_NEAR(difference(1e-3) / difference(1e-4), 10.0, 0.5); // one order more
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
      EXPECT_NEAR(isotropicDensity(bias, metricOf(map)), planar, 1e-13 * (1.0 + planar));
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

TEST(MetricDensity, IsConvexInTheMetricWithoutBias)
{
  for (const Eigen::Matrix2d& map : planarMaps())
  {
    const MetricDensity density = evaluateIsotropicDensity(0.0, metricOf(map));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(density.hessian);
    EXPECT_GT(solver.eigenvalues()[0], -1e-12 * solver.eigenvalues()[2]);
  }
}
