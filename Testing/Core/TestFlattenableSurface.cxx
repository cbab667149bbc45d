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

TEST(FlattenableSurface, LeavesNothingWhenItIsCancelled)
{
  int asked = 0;
  Execution run;
  run.cancel = [&asked] { return ++asked > 40; };
  const FlattenableSurface cancelled = flattenable(cushion(12, 12, 0.2), {}, run);
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

TEST(FlattenableSurface, DoesNotEnterABody)
{
  // The dome sinks as it is made flattenable; the body fills it up to a little below the top.
  const Surface surface = cushion(12, 12, 0.2);
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
