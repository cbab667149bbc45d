// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Types.h"
#include "Cloth/ClothMaterial.h"
#include "Flattened.h"
#include "StatusTesting.h"

using namespace flattening;
using namespace statustesting;
using namespace testmeshes;

namespace
{
FlatteningOptions on(const std::string& material, double degrees = 0.0)
{
  FlatteningOptions options;
  options.cloth =
    ClothOptions{ *findPreset(material), GrainKind::Upright, {}, {}, degrees * pi / 180.0 };
  return options;
}

FlatteningOptions along(const std::string& material, const std::string& curve, double degrees)
{
  FlatteningOptions options = on(material);
  options.cloth->grain = GrainKind::Curve;
  options.cloth->grainAngles = { degrees * pi / 180.0 };
  options.cloth->grainCurves = { curve };
  return options;
}

/// At its minimum with all promises but that of the limits.
bool flattened(const FlatteningResult& result)
{
  return result.status.ok() || result.status.code == StatusCode::BeyondLimits;
}

/// A doubly curved piece with two accessory curves.
Surface shell()
{
  return withCurves(cushion(10, 12, 0.25), { columnCurve(10, 12, 5), rowCurve(10, 6) });
}

/// The tangents of a helix between two distances from it. Each strip between neighbouring tangents
/// is two flat triangles, so that it can be unrolled as it is; no two of them lie in one plane.
Surface tangentDevelopable(Index strips, Index division)
{
  const auto tangentPoint = [](double turn, double distance) {
    const double rise = 0.4;
    const Point3 helix(std::cos(turn), std::sin(turn), rise * turn);
    return Point3(
      helix + distance * Point3(-std::sin(turn), std::cos(turn), rise) / std::hypot(1.0, rise));
  };
  return patch(division * strips, division, [&](double i, double j) {
    const double strip = std::min(std::floor(i / division), strips - 1.0);
    const double a = i / division - strip;
    const double b = j / division;
    const Point3 begin = tangentPoint(0.2 * strip, 0.3);
    const Point3 end = tangentPoint(0.2 * (strip + 1.0), 1.5);
    return a >= b
      ? Point3((1.0 - a) * begin + (a - b) * tangentPoint(0.2 * (strip + 1.0), 0.3) + b * end)
      : Point3((1.0 - b) * begin + (b - a) * tangentPoint(0.2 * strip, 1.5) + a * end);
  });
}

/// Root mean square of both threads.
double threadRms(const FlatteningResult& result)
{
  const ClothSummary& threads = result.pieces.front().cloth->threads;
  return std::sqrt(0.5 * (threads.warpRms * threads.warpRms + threads.weftRms * threads.weftRms));
}

/// From start to end of a curve, in the plane.
Point2 chord(const FlatteningResult& result, Index curve)
{
  for (const Wire& wire : result.wires)
  {
    if (wire.curve == curve)
    {
      return result.positions[wire.vertices.back()] - result.positions[wire.vertices.front()];
    }
  }
  return Point2::Zero();
}
}

TEST(ClothFlattening, TheIsotropicSheetIsThePlainScheme)
{
  const Surface surface = shell();
  const FlatteningResult plain = flatten(surface, {});
  const FlatteningResult sheet = flatten(surface, on("isotropic"));
  EXPECT_LT(largestDistance(plain.positions, sheet.positions), 1e-6);
  EXPECT_GT(threadRms(sheet), 0.0);
  EXPECT_FALSE(sheet.pieces.front().cloth->solved);
  EXPECT_FALSE(plain.pieces.front().cloth.has_value());
  EXPECT_TRUE(plain.threads.empty());
}

TEST(ClothFlattening, ThreadsAreStrainedLessThanInTheIsotropicSheetAndLengthsHold)
{
  const Surface surface = shell();
  const double before = threadRms(flatten(surface, on("isotropic")));
  for (const char* material : { "plain", "twill", "woven-carbon" })
  {
    const FlatteningResult result = flatten(surface, on(material));
    ASSERT_TRUE(flattened(result)) << material << ": " << result.status.message;
    EXPECT_LT(threadRms(result), 0.75 * before) << material;
    EXPECT_LT(worstLength(result), 1e-12) << material;
    EXPECT_TRUE(result.pieces.front().quality.flipped.empty());
    EXPECT_TRUE(result.pieces.front().cloth->solved);
  }
}

TEST(ClothFlattening, DevelopablePiecesAreExactAtAnyGrain)
{
  for (const Surface& surface :
    { cylinder(12, 6), cone(12, 6), flatPatch(8, 9), tangentDevelopable(5, 4) })
  {
    for (const char* material : { "twill", "jersey", "laminate" })
    {
      for (const double degrees : { 0.0, 23.0, 45.0, -80.0 })
      {
        const FlatteningResult result = flattenOk(surface, on(material, degrees));
        EXPECT_LT(threadRms(result), 1e-8) << material << " at " << degrees;
        EXPECT_LT(result.pieces.front().cloth->threads.shearRms, 1e-8);
        EXPECT_EQ(result.pieces.front().cloth->threads.shareOutOfLimit, 0.0);
      }
      FlatteningOptions free = on(material);
      free.cloth->grain = GrainKind::Free;
      const FlatteningResult result = flattenOk(surface, free);
      EXPECT_LT(threadRms(result), 1e-8) << material;
    }
  }
}

TEST(ClothFlattening, TheGrainRunsAlongItsCurve)
{
  const Surface surface = shell();
  for (const double degrees : { 0.0, 45.0, -30.0, 90.0 })
  {
    const FlatteningResult result = flatten(surface, along("twill", "column5", degrees));
    ASSERT_TRUE(flattened(result)) << result.status.message;
    const GrainReport& grain = result.pieces.front().cloth->grain;
    EXPECT_EQ(grain.curve, 0);
    EXPECT_FALSE(grain.missing);
    EXPECT_NEAR(grain.angle, degrees * pi / 180.0, 1e-9);
    // The warp points up; it lies counter-clockwise of the curve.
    const Point2 curve = chord(result, 0);
    const double angle = std::atan2(cross(curve, Point2::UnitY()), curve.y());
    EXPECT_NEAR(angle, degrees * pi / 180.0, 1e-9);
  }
}

TEST(ClothFlattening, TurningTheSurfaceWithItsGrainChangesNothing)
{
  const Surface surface = shell();
  const Surface moved = movedRigidly(surface);
  for (const FlatteningOptions& options :
    { on("twill", 20.0), along("twill", "column5", 10.0), along("jersey", "row6", -35.0) })
  {
    EXPECT_LT(
      largestDistance(flatten(surface, options).positions, flatten(moved, options).positions),
      1e-7);
  }
}

TEST(ClothFlattening, AFreeGrainIsNoWorseThanAnyThatIsGiven)
{
  const Surface surface = shell();
  FlatteningOptions options = on("stretch-woven");
  options.cloth->grain = GrainKind::Free;
  const FlatteningResult free = flatten(surface, options);
  ASSERT_TRUE(flattened(free)) << free.status.message;
  const auto energy = [](const FlatteningResult& result) {
    return result.pieces.front().distortionEnergy;
  };
  for (double degrees = 0.0; degrees < 180.0; degrees += 30.0)
  {
    EXPECT_LE(energy(free), 1.02 * energy(flatten(surface, on("stretch-woven", degrees))));
  }
}

TEST(ClothFlattening, LimitsTakeBackWhatIsBeyondThem)
{
  const Surface surface = shell();
  FlatteningOptions options = on("jersey");
  ClothMaterial& cloth = options.cloth->material;
  cloth.warpLimits = cloth.weftLimits = {};
  cloth.shearLimit = std::numeric_limits<double>::infinity();
  const FlatteningResult without = flatten(surface, options);
  EXPECT_EQ(without.pieces.front().cloth->threads.shareOutOfLimit, 0.0);
  const double rms = without.pieces.front().cloth->threads.warpRms;
  cloth.warpLimits = { -rms, rms };
  const FlatteningResult with = flatten(surface, options);
  ASSERT_TRUE(flattened(with)) << with.status.message;
  EXPECT_LT(with.pieces.front().cloth->threads.warpRms, rms);
  // What is beyond, by the strains that were measured.
  const auto beyond = [rms](const FlatteningResult& result) {
    double sum = 0.0;
    for (Index t = 0; t < result.cut->mesh.triangleCount(); ++t)
    {
      const double excess = std::max(0.0, std::abs(result.threads[t].warp) - rms);
      sum += result.cut->mesh.area(t) * excess * excess;
    }
    return sum;
  };
  EXPECT_LT(beyond(with), 0.6 * beyond(without));
}

TEST(ClothFlattening, StrainsThatTheBoundaryForcesAreNotSpreadBeyondThoseOfTheIsotropicSheet)
{
  for (const double height : { 0.3, 0.5 })
  {
    const Surface surface = cushion(12, 12, height);
    for (const char* material : { "plain", "twill" })
    {
      FlatteningOptions options = on(material);
      options.cloth->grain = GrainKind::Free;
      FlatteningOptions sheet = on("isotropic");
      sheet.cloth->grain = GrainKind::Free;
      const auto share = [&](const FlatteningOptions& asked) {
        return flatten(surface, asked).pieces.front().cloth->threads.shareOver5Percent;
      };
      EXPECT_LE(share(options), share(sheet)) << material << " at height " << height;
    }
  }
}

TEST(ClothFlattening, WiresBetweenSliversAreNotGivenUpForTheCloth)
{
  // Half of it is pressed to a billionth of its width.
  const Surface surface = patch(8, 8, [](double i, double j) {
    const double u = i / 8.0;
    const double v = j / 8.0;
    return Point3(u < 0.5 ? u : 0.5 + 1e-9 * (u - 0.5), v, 0.2 * std::sin(6.0 * v) * u);
  });
  const double before = worstLength(flatten(surface, {}));
  for (const char* material : { "twill", "jersey" })
  {
    const FlatteningResult result = flatten(surface, on(material));
    EXPECT_LT(worstLength(result), std::max(1e-6, 10.0 * before)) << material;
  }
}

TEST(ClothFlattening, LimitsThatCannotBeMetNameTrianglesAndTheWire)
{
  const Surface surface = shell();
  const FlatteningResult result = flatten(surface, on("laminate"));
  EXPECT_EQ(result.status.code, StatusCode::BeyondLimits);
  EXPECT_EQ(result.pieces.front().status.code, StatusCode::BeyondLimits);
  const ClothReport& report = *result.pieces.front().cloth;
  EXPECT_GT(report.threads.shareOutOfLimit, 0.2);
  const Indices out(result.status.ids.values.begin(), result.status.ids.values.end());
  EXPECT_EQ(result.status.ids.kind, ElementKind::Cells);
  EXPECT_EQ(out, report.outOfLimit);
  // By the strains alone: all that are beyond, and of these the one farthest beyond first.
  const ClothMaterial laminate = *findPreset("laminate");
  const auto beyond = [&](Index t) {
    const ThreadStrain& strain = result.threads[t];
    return std::max({ std::abs(strain.warp) / laminate.warpLimits.greatest,
      std::abs(strain.weft) / laminate.weftLimits.greatest,
      std::abs(strain.shear) / laminate.shearLimit });
  };
  for (Index t = 0; t < result.cut->mesh.triangleCount(); ++t)
  {
    EXPECT_EQ(std::count(out.begin(), out.end(), t), beyond(t) > 1.0 ? 1 : 0) << t;
    EXPECT_LE(beyond(t), beyond(out.front()) * (1.0 + 1e-12)) << t;
  }
  ASSERT_TRUE(report.limitedByBoundary || report.limitingCurve != none);
  const std::string wire = report.limitedByBoundary
    ? "along the boundary"
    : "along \"" + result.curves[report.limitingCurve].name + "\"";
  EXPECT_NE(result.status.message.find(wire), std::string::npos) << result.status.message;
  EXPECT_NE(result.status.message.find("laminate"), std::string::npos);
  EXPECT_TRUE(has(result.status, Remedy::AddDarts));
  EXPECT_TRUE(has(result.status, Remedy::TakeSofterCloth));
  EXPECT_LT(worstLength(result), 1e-12);
}

TEST(ClothFlattening, AGrainThatFollowsABentCurveIsSaidAndByHowMuch)
{
  // Two legs of one length at right angles: the corner is 1 / sqrt(2) of a leg from the chord.
  constexpr Index columns = 8;
  Surface surface = unitSquares(columns, columns);
  const auto at = [](Index i, Index j) { return j * (columns + 1) + i; };
  surface.curves = { accessory("bent",
                       { at(2, 2), at(3, 2), at(4, 2), at(5, 2), at(5, 3), at(5, 4), at(5, 5) }),
    accessory("straight", { at(1, 6), at(2, 6), at(3, 6), at(4, 6) }) };
  const FlatteningResult askew = flattenOk(surface, along("twill", "bent", 0.0));
  EXPECT_NEAR(askew.pieces.front().cloth->grain.bend, std::sqrt(0.5) / 2.0, 1e-9);
  ASSERT_EQ(askew.pieces.front().fallbacks.size(), 1U);
  EXPECT_NE(askew.pieces.front().fallbacks.front().find("\"bent\""), std::string::npos);
  EXPECT_NE(askew.pieces.front().fallbacks.front().find("35.36 %"), std::string::npos)
    << askew.pieces.front().fallbacks.front();

  const FlatteningResult plumb = flatten(surface, along("twill", "straight", 0.0));
  EXPECT_LT(plumb.pieces.front().cloth->grain.bend, 1e-9);
  EXPECT_TRUE(plumb.pieces.front().fallbacks.empty());
}

TEST(ClothFlattening, OtherSchemesAreMeasured)
{
  const Surface surface = shell();
  for (const Scheme scheme : { Scheme::Global, Scheme::LeastSquaresConformal })
  {
    FlatteningOptions options = on("twill", 10.0);
    options.scheme = scheme;
    const FlatteningResult result = flatten(surface, options);
    ASSERT_FALSE(result.status.refused());
    EXPECT_FALSE(result.pieces.front().cloth->solved);
    EXPECT_GT(threadRms(result), 0.0);
    EXPECT_NEAR(result.pieces.front().cloth->grain.angle, 10.0 * pi / 180.0, 1e-9);
  }
}

TEST(ClothFlattening, EachCurveOfTheGrainNeedsAnAngle)
{
  const Surface surface = shell();
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  const std::string curve = surface.curves.front().name;
  const std::vector<std::pair<std::vector<std::string>, std::vector<double>>> wrong{ { { curve },
                                                                                       {} },
    { { "waist", curve }, { 0.0 } }, { {}, { 0.0 } }, { { curve }, { 0.0, 0.0 } },
    { { curve }, { nothing } }, { { "waist", curve }, { -endless, 0.0 } } };
  for (const Scheme scheme : { Scheme::Isometric, Scheme::LeastSquaresConformal })
  {
    for (const auto& [curves, angles] : wrong)
    {
      FlatteningOptions options = along("twill", curve, 0.0);
      options.scheme = scheme;
      options.cloth->grainCurves = curves;
      options.cloth->grainAngles = angles;
      const FlatteningResult result = flatten(surface, options);
      EXPECT_EQ(codeOf(result.status), StatusCode::InvalidOption);
      EXPECT_TRUE(result.pieces.empty());
    }
  }
}

TEST(ClothFlattening, TheWorstOfSeveralBrokenPromisesIsTheStatusAndTellsTheOthers)
{
  const Surface surface = shell();
  const FlatteningResult result = flatten(surface, along("laminate", "waist", 0.0));
  EXPECT_EQ(result.status.code, StatusCode::MissingGrain);
  EXPECT_NE(result.status.message.find("beyond the limits"), std::string::npos);
  EXPECT_TRUE(has(result.status, Remedy::NameGrain));
  EXPECT_TRUE(has(result.status, Remedy::AddDarts));
}
