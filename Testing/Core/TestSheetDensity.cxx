// SPDX-License-Identifier: BSD-3-Clause
#include "Cloth/ClothMaterial.h"
#include "Sewing/SheetDensity.h"

#include <gtest/gtest.h>

using namespace flattening;

namespace
{
/// The metric of a map that stretches weft and warp and shears them.
Eigen::Vector3d metricOf(double warp, double weft, double shear)
{
  return { (1.0 + weft) * (1.0 + weft), (1.0 + warp) * (1.0 + warp),
    (1.0 + weft) * (1.0 + warp) * std::sin(shear) };
}

std::vector<SheetDensity> sheets()
{
  std::vector<SheetDensity> all{ SheetDensity(0.0), SheetDensity(0.3) };
  for (const char* name : { "twill", "jersey", "leather" })
  {
    all.emplace_back(*findPreset(name));
  }
  return all;
}
}

TEST(SheetDensity, DerivativesAreThoseOfFiniteDifferences)
{
  for (const SheetDensity& sheet : sheets())
  {
    for (const Eigen::Vector3d& metric :
      { metricOf(0.05, -0.03, 0.2), metricOf(-0.2, 0.3, -0.6), metricOf(0.01, 0.02, 0.0) })
    {
      const MetricDensity at = sheet.evaluate(metric);
      EXPECT_DOUBLE_EQ(at.value, sheet.value(metric));
      const double step = 1e-6;
      for (int k = 0; k < 3; ++k)
      {
        Eigen::Vector3d up = metric;
        Eigen::Vector3d down = metric;
        up[k] += step;
        down[k] -= step;
        EXPECT_NEAR(at.gradient[k], (sheet.value(up) - sheet.value(down)) / (2.0 * step), 1e-8);
        const Eigen::Vector3d bend =
          (sheet.evaluate(up).gradient - sheet.evaluate(down).gradient) / (2.0 * step);
        EXPECT_LT((at.hessian.col(k) - bend).norm(), 1e-6 * (1.0 + bend.norm()));
      }
    }
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
