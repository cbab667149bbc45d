// SPDX-License-Identifier: BSD-3-Clause
// What is said of a surface before it is flattened, against the sphere, of which all is known.
#include "Quality/AreaForecast.h"
#include "SphereCap.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A cap of the unit sphere down to an angle has the area 2 pi (1 - cos angle); the disk with the
/// length of its boundary, which holds more than any other figure, pi sin^2 angle.
double lossOfCap(double angle)
{
  return 1.0 - 0.5 * std::pow(std::sin(angle), 2) / (1.0 - std::cos(angle));
}
}

TEST(AreaForecast, IsWhatADiskWithTheBoundaryOfACapOfTheSphereLacks)
{
  for (double degrees : { 70.0, 90.0, 120.0, 150.0, 170.0 })
  {
    const double angle = degrees * pi / 180.0;
    const AreaForecast forecast = forecastArea(sphereCap(angle, 24, 0).mesh, {});
    EXPECT_TRUE(forecast.known && forecast.deep()) << degrees;
    EXPECT_NEAR(forecast.loss, lossOfCap(angle), 0.01) << degrees;
  }
}

TEST(AreaForecast, SaysNothingOfWhatLiesWell)
{
  // At 60 degrees a quarter is lost; the threshold is 0.3.
  for (double degrees : { 10.0, 45.0, 60.0 })
  {
    const AreaForecast forecast = forecastArea(sphereCap(degrees * pi / 180.0, 12, 0).mesh, {});
    EXPECT_TRUE(forecast.known && !forecast.deep()) << degrees;
    EXPECT_EQ(forecast.loss, 0.0);
    EXPECT_TRUE(forecast.cut.empty());
  }
}

TEST(AreaForecast, CutsFromTheBoundaryToThePoleOfACapAndLosesLessThen)
{
  constexpr Index rings = 16;
  const TriangleMesh mesh = sphereCap(2.2, rings, 0).mesh;
  const AreaForecast forecast = forecastArea(mesh, {});
  ASSERT_EQ(forecast.cut.size(), std::size_t(rings + 1));
  EXPECT_TRUE(mesh.onBoundary(forecast.cut.front()));
  EXPECT_EQ(forecast.cut.back(), 0); // the pole
  EXPECT_LT(forecast.lossAfterCut, 0.75 * forecast.loss);
  EXPECT_GT(forecast.lossAfterCut, 0.0);
}
