// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Types.h"
#include "Cloth/ClothEnergy.h"
#include "Cloth/ClothMaterial.h"
#include "ModelDerivatives.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// J by its rows, to parts (q, p).
Eigen::Vector4d partsOf(const Eigen::Matrix2d& J)
{
  return { J(0, 0) + J(1, 1), J(1, 0) - J(0, 1), J(0, 0) - J(1, 1), J(1, 0) + J(0, 1) };
}

Eigen::Matrix2d turn(double angle)
{
  Eigen::Matrix2d R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

/// Maps with singular values about 1, some far from it, in all directions.
std::vector<Eigen::Matrix2d> sampleMaps(double strain)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Eigen::Matrix2d> maps;
  for (int k = 0; k < 60; ++k)
  {
    Eigen::Matrix2d S = Eigen::Matrix2d::Identity();
    S(0, 0) += strain * uniform(random);
    S(1, 1) += strain * uniform(random);
    S(0, 1) = S(1, 0) = strain * uniform(random);
    maps.emplace_back(turn(pi * uniform(random)) * S);
  }
  return maps;
}

/// Parts of the map to the plane of cloth whose threads are strained in wear: the plane is shorter.
Eigen::Vector4d strained(double weft, double warp)
{
  return partsOf(Eigen::Vector2d(1.0 / (1.0 + weft), 1.0 / (1.0 + warp)).asDiagonal());
}

/// All presets that have threads, and one with a coupling.
std::vector<ClothMaterial> woven()
{
  std::vector<ClothMaterial> all;
  for (const ClothMaterial& preset : materialPresets())
  {
    if (!preset.isotropic)
    {
      all.push_back(preset);
    }
  }
  all.push_back(all.front());
  all.back().cross = 0.3 * all.back().weft;
  return all;
}

/// Alike in all directions for small strains, without a Poisson's effect.
ClothMaterial plainSheet()
{
  ClothMaterial sheet;
  sheet.warp = sheet.weft = 100.0;
  sheet.shear = 50.0;
  return sheet;
}
}

// Its derivatives inside are tried with those of the energy.
TEST(SmoothRamp, HasTwoContinuousDerivatives)
{
  const double width = 0.3;
  for (const double joint : { 0.0, width })
  {
    const Curve2 before = smoothRamp(joint - 1e-12, width);
    const Curve2 after = smoothRamp(joint + 1e-12, width);
    EXPECT_NEAR(before.value, after.value, 1e-11);
    EXPECT_NEAR(before.first, after.first, 1e-11);
    EXPECT_NEAR(before.second, after.second, 1e-9);
  }
}

TEST(ClothEnergy, GradientAndHessianAreThoseOfFiniteDifferences)
{
  for (const ClothMaterial& material : woven())
  {
    SCOPED_TRACE(material.name);
    const ClothEnergy energy(material, 100.0);
    const auto evaluate = [&energy](
                            const Eigen::Vector4d& parts) { return energy.evaluate(parts, false); };
    for (const double size : { 0.003, 0.03, 0.3 })
    {
      for (const Eigen::Matrix2d& J : sampleMaps(size))
      {
        const Eigen::Vector4d parts = partsOf(J);
        const DistortionEnergyValue value = evaluate(parts);
        EXPECT_NEAR(value.value, energy.density(parts), 1e-12 * (1.0 + value.value));
        EXPECT_EQ(energy.gradient(parts), value.gradient);
        const double scale = 1.0 + value.gradient.norm() + value.hessian.norm();
        // Third derivatives jump at the limits: a short step for the Hessian.
        expectDensityDerivatives(evaluate, parts, 1e-6, 1e-8, 1e-6 * scale);
      }
    }
  }
}

TEST(ClothEnergy, ConvexHessianIsTheNearestWithoutNegativeEigenvalues)
{
  for (const ClothMaterial& material : woven())
  {
    const ClothEnergy energy(material, 100.0);
    for (const Eigen::Matrix2d& J : sampleMaps(0.2))
    {
      const Eigen::Matrix4d exact = energy.evaluate(partsOf(J), false).hessian;
      const Eigen::Matrix4d convex = energy.evaluate(partsOf(J), true).hessian;
      EXPECT_LT((convex - nearestConvex(exact)).norm(), 1e-10 * exact.norm());
    }
  }
}

TEST(ClothEnergy, DrawsThreadsByTheirOwnStiffnessAndCompressesThemMoreSoftly)
{
  ClothMaterial cloth = plainSheet();
  cloth.warp = 1000.0;
  cloth.weft = 250.0;
  cloth.shear = 10.0;
  cloth.compression = 0.25;
  const ClothEnergy energy(cloth, 0.0);
  // Of the cloth's area.
  const auto stretched = [&](double weft, double warp) {
    return energy.density(strained(weft, warp)) * (1.0 + weft) * (1.0 + warp);
  };
  const double e = 0.04;
  // But for the joint of both stiffnesses, which is 0.1 % wide.
  EXPECT_NEAR(stretched(0.0, e), e * e, 0.02 * e * e);
  EXPECT_NEAR(stretched(e, 0.0), 0.25 * e * e, 0.02 * 0.25 * e * e);
  EXPECT_NEAR(stretched(0.0, -e), 0.25 * e * e, 0.04 * 0.25 * e * e);
}

TEST(ClothEnergy, StrainsBeyondALimitCostMoreAndFarBeyondItInProportion)
{
  ClothMaterial cloth = plainSheet();
  cloth.warpLimits = { -0.01, 0.02 };
  cloth.shearLimit = 0.1;
  const ClothEnergy free(cloth, 0.0);
  const ClothEnergy limited(cloth, 50.0);
  for (const double within : { 0.019, -0.009 })
  {
    EXPECT_EQ(limited.density(strained(0.0, within)), free.density(strained(0.0, within)));
  }
  for (const double beyond : { 0.05, -0.04 })
  {
    EXPECT_GT(limited.density(strained(0.0, beyond)), 5.0 * free.density(strained(0.0, beyond)));
  }
  // Of the cloth's area, which a strain of the warp leaves over 1 + strain.
  const auto limit = [&](double warp) {
    const Eigen::Vector4d parts = strained(0.0, warp);
    return (1.0 + warp) * (limited.density(parts) - free.density(parts));
  };
  for (const double side : { 1.0, -1.0 })
  {
    const double first = limit(0.3 * side) - limit(0.2 * side);
    const double second = limit(0.4 * side) - limit(0.3 * side);
    EXPECT_GT(first, 0.0);
    EXPECT_NEAR(second, first, 1e-9 * first);
    EXPECT_GT(limit(0.06 * side) - limit(0.05 * side), limit(0.05 * side) - limit(0.04 * side));
  }
}

TEST(ClothEnergy, IsInfiniteWhereATriangleIsTurnedOver)
{
  const ThreadStrain strain = threadStrain({ -1.0, 0.0 }, { 0.0, 1.0 });
  EXPECT_FALSE(isPossible(strain));
  EXPECT_EQ(strain.warp, largestThreadStrain);
  const ClothEnergy energy(plainSheet(), 1.0);
  const Eigen::Matrix2d J = Eigen::Vector2d(1.0, -1.0).asDiagonal();
  EXPECT_TRUE(std::isinf(energy.density(partsOf(J))));
  EXPECT_TRUE(energy.evaluate(partsOf(J), true).hessian.allFinite());
}

TEST(ClothMaterial, PresetsAreSound)
{
  for (const ClothMaterial& preset : materialPresets())
  {
    EXPECT_TRUE(checkMaterial(preset).ok()) << preset.name;
  }
}
