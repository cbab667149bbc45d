// SPDX-License-Identifier: BSD-3-Clause
#include "Reshaping/FlattenableSurface.h"
#include "Sewing/BodyContact.h"
#include "TestMeshes.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
FlattenableSurface flattenable(
  const Surface& surface, const FlattenableOptions& options = {}, const Execution& run = {})
{
  return makeFlattenable(surface.mesh, surface.curves, options, run);
}

/// A patch that is strained by a multiple of the bound.
Surface dome()
{
  return cushion(12, 12, 0.2);
}

}

TEST(FlattenableSurface, KeptCurvesStayAndKeepTheirLengthsInThePlane)
{
  Surface surface = withCurves(dome(), { rowCurve(12, 6) });
  FlattenableOptions options;
  options.kept = { 0 };
  const FlattenableSurface result = flattenable(surface, options);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LT(result.strainAfter, result.strainBefore);
  const Indices row = surface.curves.front().vertices;
  for (std::size_t k = 0; k < row.size(); ++k)
  {
    EXPECT_EQ(result.mesh.point(row[k]), surface.mesh.point(row[k]));
    if (k > 0)
    {
      const double flat =
        (result.after.positions[row[k]] - result.after.positions[row[k - 1]]).norm();
      const double designed = (surface.mesh.point(row[k]) - surface.mesh.point(row[k - 1])).norm();
      EXPECT_NEAR(flat / designed, 1.0, 1e-12);
    }
  }
  EXPECT_GT(result.shift.max, 0.0);
}

TEST(FlattenableSurface, WhatLiesFlatAlreadyIsNotTouched)
{
  for (const Surface& surface : { cylinder(16, 8), cone(16, 8) })
  {
    const FlattenableSurface result = flattenable(surface);
    ASSERT_TRUE(result.status.ok());
    EXPECT_TRUE(result.boundMet);
    EXPECT_EQ(result.shift.max, 0.0);
    EXPECT_TRUE(result.mesh.identical(surface.mesh));
    EXPECT_EQ(result.trials.size(), 1U);
  }
}

TEST(FlattenableSurface, ADartLessensTheShift)
{
  const auto shift = [](bool dart) {
    Surface surface = cushion(12, 12, 0.35);
    if (dart)
    {
      surface.curves = { curveOf(CurveType::Dart, "dart", { 6, 19, 32, 45, 58 }) };
    }
    const FlattenableSurface result = flattenable(surface);
    EXPECT_TRUE(result.boundMet);
    // Both sides stay one curve on the surface.
    EXPECT_EQ(result.mesh.vertexCount(), surface.mesh.vertexCount());
    return result.shift.mean;
  };
  EXPECT_LT(shift(true), 0.9 * shift(false));
}

TEST(FlattenableSurface, ATighterBoundMovesItFarther)
{
  double before = 0.0;
  for (const double bound : { 0.03, 0.02, 0.01 })
  {
    FlattenableOptions options;
    options.bound = bound;
    const FlattenableSurface result = flattenable(dome(), options);
    EXPECT_TRUE(result.boundMet);
    EXPECT_GT(result.strainBefore, 0.04);
    EXPECT_LE(result.strainAfter, bound);
    EXPECT_LE(result.shift.p95, result.shift.max);
    if (bound == 0.02) // not farther than it takes
    {
      EXPECT_GT(result.strainAfter, 0.017);
      EXPECT_LT(result.shift.mean, 0.025 * result.shift.size);
    }
    EXPECT_GT(result.shift.mean, before);
    before = result.shift.mean;
  }
}

TEST(FlattenableSurface, ABoundThatIsNotMetIsToldWithTheLeastStrain)
{
  // All vertices are held.
  Surface surface = cushion(4, 4, 0.3);
  FlattenableOptions options;
  for (Index row = 1; row < 4; ++row)
  {
    surface.curves.push_back(rowCurve(4, row));
    options.kept.push_back(row - 1);
  }
  const FlattenableSurface result = flattenable(surface, options);
  ASSERT_FALSE(result.status.refused());
  EXPECT_FALSE(result.boundMet);
  EXPECT_GT(result.strainAfter, options.bound);
  EXPECT_EQ(result.strainAfter, result.strainBefore);
  EXPECT_EQ(result.shift.max, 0.0);
  EXPECT_EQ(
    result.hindrance, "every vertex is kept where it is: 100 % of the area is kept where it is");
}

TEST(FlattenableSurface, UnitAndThreadsChangeNothing)
{
  const Surface surface = cushion(6, 6, 0.2);
  const FlattenableSurface one = flattenable(surface);
  const FlattenableSurface three = flattenable(surface, {}, withThreads(3));
  EXPECT_TRUE(one.mesh.identical(three.mesh));
  Surface scaled = surface;
  scaled.mesh = moved(surface.mesh, [](const Point3& p) -> Point3 { return 1024.0 * p; });
  const FlattenableSurface other = flattenable(scaled);
  EXPECT_NEAR(other.shift.mean / one.shift.mean / 1024.0, 1.0, 1e-6);
  EXPECT_NEAR(other.strainAfter / one.strainAfter, 1.0, 1e-6);
}

TEST(FlattenableSurface, RefusesWhatMeansNothingAndStopsWhenTold)
{
  std::vector<FlattenableOptions> wrong;
  for (const double bound : { 0.0, -1.0, 1.0, std::nan("") })
  {
    wrong.emplace_back().bound = bound;
  }
  for (const double bias : { -0.1, 1.1, std::nan("") })
  {
    wrong.emplace_back().outsideBias = bias;
  }
  wrong.emplace_back().thickness = 2.0;
  wrong.emplace_back().kept = { 7 };
  for (const FlattenableOptions& options : wrong)
  {
    EXPECT_EQ(flattenable(dome(), options).status.code, StatusCode::InvalidOption);
  }

  int asked = 0;
  Execution run;
  run.cancel = [&asked] { return ++asked > 40; };
  const FlattenableSurface cancelled = flattenable(dome(), {}, run);
  EXPECT_EQ(cancelled.status.code, StatusCode::Cancelled);
  EXPECT_EQ(cancelled.mesh.vertexCount(), 0);
}

namespace
{
/// A surface over a square with a height (x, y), its normals upwards or, turned, downwards.
Surface overSquare(const std::function<double(double, double)>& height, bool turned)
{
  const TriangleMesh mesh = heightField(12, height).mesh;
  Triangles triangles = mesh.triangles();
  for (Triangle& c : triangles)
  {
    std::swap(c[1], c[turned ? 2 : 1]);
  }
  return { TriangleMesh(mesh.points(), std::move(triangles)), {}, {} };
}

Surface saddle(double height, bool turned)
{
  return overSquare([height](double x, double y) { return height * (x * x - y * y); }, turned);
}

FlattenableSurface withBias(const Surface& surface, double bias)
{
  FlattenableOptions options;
  options.outsideBias = bias;
  return flattenable(surface, options);
}
}

TEST(FlattenableSurface, AnOutsideBiasTakesASaddleToTheSideOfItsNormals)
{
  // Both sides of the convex hull of its boundary are developable.
  for (const bool turned : { false, true })
  {
    const Surface surface = saddle(0.3, turned);
    const ContactBody design(surface.mesh);
    double before = -1.0;
    for (const double bias : { 0.0, 0.9, 1.0 })
    {
      const FlattenableSurface result = withBias(surface, bias);
      ASSERT_TRUE(result.status.ok()) << result.status.message;
      EXPECT_GT(result.strainBefore, 0.03);
      EXPECT_TRUE(result.boundMet) << bias << " " << result.strainAfter;
      double mean = 0.0;
      double deepest = 0.0;
      for (const Point3& p : result.mesh.points())
      {
        const double distance = design.locate(p).distance;
        mean += distance / result.mesh.vertexCount();
        deepest = std::min(deepest, distance);
      }
      EXPECT_GT(mean, before);
      before = mean;
      if (bias == 1.0)
      {
        EXPECT_LE(result.shift.inwardsMax, 1e-12);
        EXPECT_GT(result.shift.outwardsMean, 0.5 * result.shift.mean);
        EXPECT_GE(deepest, -1e-3 * result.shift.size);
      }
    }
    EXPECT_GT(before, 0.0);
  }
}

TEST(FlattenableSurface, AFullBiasReachesTheBoundOnSaddlesOfAllHeights)
{
  const auto reaches = [](const Surface& surface, const std::string& name) {
    const FlattenableSurface result = withBias(surface, 1.0);
    EXPECT_TRUE(result.boundMet) << name << " " << result.strainAfter << " " << result.hindrance;
    EXPECT_EQ(result.hindrance, "");
    EXPECT_LE(result.shift.inwardsMax, 1e-12);
  };
  for (const bool turned : { false, true })
  {
    for (double height = 0.15; height < 0.95; height += 0.1)
    {
      reaches(saddle(height, turned), "saddle " + std::to_string(height));
    }
    // No plane of symmetry between rise and fall; three valleys.
    for (const double height : { 0.2, 0.45, 0.7 })
    {
      reaches(overSquare(
                [height](double x, double y) {
                  return height * ((x * x - y * y) * (1.0 + 0.3 * x) + 0.2 * std::sin(3.0 * x + y));
                },
                turned),
        "skew saddle " + std::to_string(height));
      reaches(
        overSquare(
          [height](double x, double y) { return height * (x * x * x - 3.0 * x * y * y); }, turned),
        "three valleys " + std::to_string(height));
    }
  }
}

TEST(FlattenableSurface, AShortfallIsToldWithWhatWasNotFreeToMove)
{
  // Over what a dome's boundary spans there is no developable surface outside of the dome.
  for (const double height : { 0.3, 0.5, 0.8 })
  {
    const auto dome = [height](double x, double y) { return height * (1.2 - x * x - y * y); };
    const FlattenableSurface result = withBias(overSquare(dome, false), 1.0);
    ASSERT_FALSE(result.status.refused());
    EXPECT_FALSE(result.boundMet);
    EXPECT_NE(result.hindrance.find("further moves hardly lower the strain: 1"), std::string::npos)
      << result.hindrance;
    EXPECT_NE(result.hindrance.find("outwards only"), std::string::npos) << result.hindrance;
    EXPECT_TRUE(withBias(overSquare(dome, true), 1.0).boundMet);
  }
}

TEST(FlattenableSurface, WithAFullBiasADomeDoesNotSinkWhereItsBoundaryMayMove)
{
  FlattenableOptions options;
  options.keepBoundary = false;
  const Surface surface = dome();
  const FlattenableSurface either = flattenable(surface, options);
  EXPECT_TRUE(either.boundMet);
  double atBoundary = 0.0;
  for (Index v = 0; v < surface.mesh.vertexCount(); ++v)
  {
    const double moved = either.shift.ofVertex[v];
    atBoundary = surface.mesh.onBoundary(v) ? std::max(atBoundary, moved) : atBoundary;
  }
  EXPECT_GT(atBoundary, 1e-3 * either.shift.size);
  EXPECT_GT(either.shift.inwardsMax, 1e-3 * either.shift.size);
  options.outsideBias = 1.0;
  const FlattenableSurface outside = flattenable(surface, options);
  EXPECT_TRUE(outside.boundMet) << outside.strainAfter;
  EXPECT_LE(outside.shift.inwardsMax, 1e-12);
  EXPECT_GT(outside.shift.outwardsMean, 0.0);
  EXPECT_GT(outside.shift.outwardsMean, either.shift.outwardsMean);
}

TEST(FlattenableSurface, DoesNotEnterABody)
{
  // The dome sinks as it is made flattenable; the body fills it up to a little below the top.
  const Surface surface = dome();
  const TriangleMesh body =
    moved(surface.mesh, [](const Point3& p) { return Point3(p.x(), p.y(), 0.95 * p.z() - 1e-3); });
  FlattenableOptions options;
  options.body = &body;
  options.bound = 0.03;
  const auto lowest = [&](const FlattenableSurface& result) {
    const ContactBody place(body);
    double least = 1.0;
    for (Index v = 0; v < result.mesh.vertexCount(); ++v)
    {
      least = result.kept[v] ? least : std::min(least, place.locate(result.mesh.point(v)).distance);
    }
    return least;
  };
  EXPECT_GE(lowest(flattenable(surface, options)), -1e-9);
  options.body = nullptr;
  EXPECT_LT(lowest(flattenable(surface, options)), -1e-3);
}
