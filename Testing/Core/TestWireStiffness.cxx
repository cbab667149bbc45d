// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/IsometricModel.h"

#include "Flattened.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr double weight = 5.0;
constexpr double area = 1600.0;

WireHinge smoothHinge(double length, bool inside)
{
  return { length, pi, inside };
}

/// A panel over [-1, 1] x [-1, 1].
Surface panel(Index side, const std::function<Point3(double, double)>& place)
{
  return patch(side, side,
    [&](double i, double j) { return place(2.0 * i / side - 1.0, 2.0 * j / side - 1.0); });
}

std::vector<std::function<Point3(double, double)>> panels()
{
  return { [](double x, double y) { return Point3(x, y, 0.4 * (x * x + y * y)); },
    [](double x, double y) { return Point3(x, y, 0.4 * (x * x - y * y)); },
    [](double x, double y) { return Point3(x, y, 0.15 * std::sin(3.0 * x) * std::cos(2.5 * y)); },
    [](double x, double y) {
      const double radius = 1.0 + 0.3 * std::sin(2.0 * y);
      return Point3(radius * std::sin(1.2 * x), radius * std::cos(1.2 * x), 1.5 * y);
    } };
}

QualitySummary qualityOf(const Surface& surface, double angleWeight = weight)
{
  FlatteningOptions options;
  options.isometric.angleWeight = angleWeight;
  const FlatteningResult result = flattenOk(surface, options);
  EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
  return result.pieces[0].quality;
}
}

TEST(WireStiffness, AChainOfHingesBendsTheSameHoweverFinelyItIsDivided)
{
  // Springs in a row: n hinges of a length l / n are together as stiff as one of length l.
  const WireStiffness stiffness(weight, area, 1.0);
  for (double force : { -3.0, 0.0, 2.0, 5.0, 50.0 })
  {
    const double whole = stiffness.underForce(smoothHinge(1.0, true), force);
    for (int parts : { 2, 3, 16 })
    {
      const double part = stiffness.underForce(smoothHinge(1.0 / parts, true), force);
      EXPECT_NEAR(part / parts, whole, 1e-12 * whole) << force << " " << parts;
    }
  }
}

TEST(WireStiffness, IsEnoughAgainstWrinklingAtTheEdgeOfASheet)
{
  // A wire of bending energy B per squared curvature at the edge of a sheet that answers a ripple
  // of wave number q by c q: ripples cost 2 B q^4 + c q, what presses gains N q^2.
  const WireStiffness stiffness(weight, area, 1.0);
  constexpr double perRipple = 4.0 / 3.0; // a half-plane of modulus 2 whose edge keeps its length
  for (double force : { 0.5, 1.0, 2.0, 3.0 })
  {
    const double bending = stiffness.underForce(smoothHinge(1.0, false), force);
    for (double q = 0.01; q < 100.0; q *= 1.1)
    {
      EXPECT_LT(force * q * q, 2.0 * bending * q * q * q * q + perRipple * q) << force << " " << q;
    }
  }
}

TEST(WireStiffness, WiresThatAreDrawnStaySoftAndPressedOnesGetStiffer)
{
  const WireStiffness stiffness(weight, area, 1.0);
  for (bool inside : { false, true })
  {
    const WireHinge hinge = smoothHinge(1.2, inside);
    const double least = stiffness.underForce(hinge, 0.0);
    EXPECT_GT(least, 0.0);
    EXPECT_EQ(stiffness.underForce(hinge, -100.0), least);
    EXPECT_GT(stiffness.underForce(hinge, 8.0), 1.5 * least);
    EXPECT_GE(stiffness.underForce(hinge, 1e9), stiffness.underForce(hinge, 8.0));
    EXPECT_TRUE(std::isfinite(stiffness.underForce(hinge, 1e9)));
  }
}

TEST(WireStiffness, AMeshOfFourTimesTheTrianglesGivesTheSameShape)
{
  for (const auto& place : panels())
  {
    const QualitySummary coarse = qualityOf(panel(20, place));
    const QualitySummary fine = qualityOf(panel(40, place));
    EXPECT_NEAR(coarse.areaError, fine.areaError, 0.04 * fine.areaError);
    EXPECT_NEAR(coarse.rigidEnergy, fine.rigidEnergy, 0.015 * fine.rigidEnergy);
  }
}

TEST(WireStiffness, WithoutCurvesItCostsAFewPercentOfEnergyAtMost)
{
  // Coarse enough for boundaries to keep their shape without any stiffness.
  for (const auto& place : panels())
  {
    const Surface surface = panel(14, place);
    EXPECT_LT(qualityOf(surface).rigidEnergy, 1.05 * qualityOf(surface, 0.0).rigidEnergy);
  }
}

TEST(WireStiffness, DoesNotDependOnWhatElseIsCutFromTheSurface)
{
  // The lower half of a cushion, alone and beside the upper half, in strips of another width.
  const auto place = [](double i, double j) {
    return Point3(i / 8.0, j <= 4.0 ? j / 8.0 : 0.5 + (j - 4.0) / 32.0,
      0.3 * std::sin(pi * i / 8.0) * std::sin(0.3 * j));
  };
  const Surface alone = patch(8, 4, place);
  Surface both = patch(8, 20, place);
  both.curves = { rowCurve(8, 4, CurveType::Seam) };
  const FlatteningResult one = flatten(alone);
  const FlatteningResult two = flatten(both);
  ASSERT_TRUE(one.status.ok() && two.status.ok()) << one.status.message << two.status.message;
  ASSERT_EQ(two.pieces.size(), 2u);
  const bool first = two.pieces[0].triangles == one.pieces[0].triangles;
  const PieceReport& same = two.pieces[first ? 0 : 1];
  EXPECT_NEAR(same.distortionEnergy, one.pieces[0].distortionEnergy, 1e-9);
  EXPECT_NEAR(same.angleEnergy, one.pieces[0].angleEnergy, 1e-9);
}
