// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Types.h"
#include "Flattened.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr Index cushionSize = 12;

FeatureCurve dart(const std::string& name, Index column, Index from, Index to)
{
  Indices vertices;
  for (Index j = from; j != to; j += from < to ? 1 : -1)
  {
    vertices.push_back(at(cushionSize, column, j));
  }
  return curveOf(CurveType::Dart, name, vertices);
}

/// A cushion with a dart from the border and one inside, both where the cushion is not symmetric.
Surface dartedCushion()
{
  return withCurves(
    cushion(cushionSize, cushionSize, 0.5), { dart("mouth", 4, 0, 6), dart("fish-eye", 8, 5, 10) });
}

FlatteningResult flatten(const Surface& surface, DartLegs legs, Scheme scheme = Scheme::Isometric)
{
  FlatteningOptions options = withScheme(scheme);
  options.dartLegs = legs;
  return flatten(surface, options);
}

/// The two legs of a dart, from its first vertex on.
std::array<Points2, 2> legsOf(const FlatteningResult& result, Index curve)
{
  std::array<Points2, 2> legs;
  std::size_t leg = 0;
  for (const Wire& wire : result.wires)
  {
    for (std::size_t k = 0; wire.curve == curve && k < wire.vertices.size(); ++k)
    {
      legs.at(leg).push_back(result.positions[wire.vertices[k]]);
    }
    leg += wire.curve == curve ? 1 : 0;
  }
  return legs;
}

/// How far a point of one leg is from its partner on the other, folded along the line from the tip.
double missOf(const std::array<Points2, 2>& legs)
{
  const Point2 tip = legs[0].back();
  const Point2 axis = ((legs[0].front() + legs[1].front()) / 2.0 - tip).normalized();
  double most = 0.0;
  for (std::size_t k = 0; k < legs[0].size(); ++k)
  {
    const Point2 way = legs[0][k] - tip;
    const Point2 folded = tip + 2.0 * axis.dot(way) * axis - way;
    most = std::max(most, (folded - legs[1][k]).norm());
  }
  return most;
}

double bendOf(const Points2& leg)
{
  const Point2 chord = (leg.back() - leg.front()).normalized();
  double most = 0.0;
  for (const Point2& p : leg)
  {
    most = std::max(most, std::abs(cross(chord, p - leg.front())));
  }
  return most;
}
}

TEST(DartFolding, LegsAreMirrorImagesInEverySchemeThatKeepsLengthsUnlessTheyAreFree)
{
  const FlatteningResult free = flatten(dartedCushion(), DartLegs::Free);
  ASSERT_TRUE(free.status.ok()) << free.status.message;
  EXPECT_GT(missOf(legsOf(free, 0)), 1e-3);
  for (const Scheme scheme : { Scheme::Isometric, Scheme::Global, Scheme::Progressive })
  {
    for (const DartLegs legs : { DartLegs::Straight, DartLegs::Mirrored })
    {
      const FlatteningResult result = flatten(dartedCushion(), legs, scheme);
      ASSERT_FALSE(result.status.refused()) << result.status.message;
      EXPECT_LT(missOf(legsOf(result, 0)), 1e-9);
      EXPECT_LT(missOf(legsOf(result, 1)), 1e-9);
      EXPECT_LT(worstLength(result), 1e-9);
    }
  }
}

TEST(DartFolding, StraightLegsAreStraightAndADartWithTwoTipsStaysOpen)
{
  const FlatteningResult result = flatten(dartedCushion(), DartLegs::Straight);
  EXPECT_LT(bendOf(legsOf(result, 0)[0]), 1e-9);
  EXPECT_LT(bendOf(legsOf(result, 0)[1]), 1e-9);
  const std::array<Points2, 2> closed = legsOf(result, 1);
  EXPECT_GT((closed[0][2] - closed[1][2]).norm(), 1e-3);
}

TEST(DartFolding, MirroredLegsAreTheMeanOfFreeOnes)
{
  const auto turn = [](const Points2& leg, std::size_t k) {
    const Point2 in = leg[k] - leg[k - 1];
    const Point2 out = leg[k + 1] - leg[k];
    return std::atan2(cross(in, out), in.dot(out));
  };
  const std::array<Points2, 2> free = legsOf(flatten(dartedCushion(), DartLegs::Free), 0);
  const std::array<Points2, 2> mirrored = legsOf(flatten(dartedCushion(), DartLegs::Mirrored), 0);
  for (std::size_t k = 1; k + 1 < free[0].size(); ++k)
  {
    const double mean = (turn(free[0], k) - turn(free[1], k)) / 2.0;
    EXPECT_NEAR(turn(mirrored[0], k), mean, 1e-9);
    EXPECT_NEAR(turn(mirrored[1], k), -mean, 1e-9);
  }
}

TEST(DartFolding, ADartThatBranchesKeepsFreeLegsAndIsNamed)
{
  Surface surface = withCurves(cushion(cushionSize, cushionSize, 0.5),
    { dart("stem", 4, 0, 6),
      curveOf(CurveType::Dart, "branch",
        { 3 * (cushionSize + 1) + 4, 3 * (cushionSize + 1) + 5, 3 * (cushionSize + 1) + 6 }),
      dart("other", 9, 0, 4) });
  const FlatteningResult result = flatten(surface, DartLegs::Straight);
  ASSERT_FALSE(result.status.refused()) << result.status.message;
  const std::vector<std::string>& fallbacks = result.pieces[0].fallbacks;
  ASSERT_EQ(fallbacks.size(), 1U);
  EXPECT_NE(fallbacks[0].find("\"stem\""), std::string::npos) << fallbacks[0];
  EXPECT_EQ(fallbacks[0].find("\"other\""), std::string::npos) << fallbacks[0];
  EXPECT_LT(missOf(legsOf(result, 2)), 1e-9);
}

TEST(DartFolding, KeysAreNotGivenUpForLegs)
{
  // The key crosses the dart's mouth row and forbids what straight legs would need.
  Surface surface = dartedCushion();
  surface.curves.push_back(rowCurve(cushionSize, 0, CurveType::Key));
  const FlatteningResult result = flatten(surface, DartLegs::Straight);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_FALSE(result.curves[2].released);
}
