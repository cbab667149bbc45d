// SPDX-License-Identifier: BSD-3-Clause
// Starts that never fold: deep caps of a sphere, with and without wires across their pole.
#include "Embedding/ConvexEmbedding.h"
#include "Flattening/SurfaceFlattening.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// The part of the unit sphere within an angle of its pole, in rings of triangles of equal size,
/// with wires along diameters, the second across the first.
Surface cap(double angle, Index rings, int wires)
{
  const auto at = [](Index ring, Index k) -> Index {
    return ring == 0 ? 0 : 1 + 2 * ring * (ring - 1) + k % (4 * ring);
  };
  Points3 points{ Point3(0.0, 0.0, 1.0) };
  Triangles triangles;
  for (Index ring = 1; ring <= rings; ++ring)
  {
    const double down = angle * ring / rings;
    for (Index k = 0; k < 4 * ring; ++k)
    {
      const double around = 2.0 * pi * k / (4 * ring);
      points.push_back(Point3(
        std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down)));
      const Index quarter = k / ring;
      const Index inner = k - quarter;
      triangles.push_back({ at(ring - 1, inner), at(ring, k), at(ring, k + 1) });
      if (k % ring != ring - 1)
      {
        triangles.push_back({ at(ring - 1, inner), at(ring, k + 1), at(ring - 1, inner + 1) });
      }
    }
  }
  Surface surface;
  surface.mesh = TriangleMesh(std::move(points), std::move(triangles));
  for (Index wire = 0; wire < wires; ++wire)
  {
    Indices vertices{ 0 };
    for (Index ring = 1; ring <= rings; ++ring)
    {
      vertices.insert(vertices.begin(), at(ring, wire * ring));
      vertices.push_back(at(ring, (wire + 2) * ring));
    }
    surface.curves.push_back(accessory("diameter" + std::to_string(wire), std::move(vertices)));
  }
  return surface;
}

FlatteningResult flatten(const Surface& surface)
{
  return flattenSurface(surface.mesh, surface.curves, {}, {});
}
}

TEST(ConvexEmbedding, FoldsNothingHoweverDeepTheSurfaceIs)
{
  for (double degrees : { 30.0, 90.0, 150.0, 175.0 })
  {
    const Surface surface = cap(degrees * pi / 180.0, 12, 0);
    const Points2 flat = embedConvexly(surface.mesh, {});
    ASSERT_EQ(flat.size(), surface.mesh.points().size());
    EXPECT_EQ(countFlipped(surface.mesh, flat), 0) << degrees;
  }
}

TEST(ConvexEmbedding, FoldsNothingAroundHoles)
{
  // A tube: its other end is a hole.
  Points3 points;
  Triangles triangles;
  constexpr Index around = 12;
  for (Index j = 0; j <= 6; ++j)
  {
    for (Index i = 0; i < around; ++i)
    {
      const double angle = 2.0 * pi * i / around;
      points.push_back(Point3(std::cos(angle), std::sin(angle), 0.5 * j));
      if (j < 6)
      {
        const Index a = around * j + i;
        const Index b = around * j + (i + 1) % around;
        triangles.push_back({ a, b, b + around });
        triangles.push_back({ a, b + around, a + around });
      }
    }
  }
  const TriangleMesh mesh(points, triangles);
  const Points2 flat = embedConvexly(mesh, {});
  ASSERT_EQ(flat.size(), mesh.points().size());
  EXPECT_EQ(countFlipped(mesh, flat), 0);
}

TEST(ConvexEmbedding, IsEmptyWhereItIsCancelled)
{
  Execution execution;
  execution.cancel = [] { return true; };
  EXPECT_TRUE(embedConvexly(cap(1.0, 4, 0).mesh, execution).empty());
}

TEST(ConvexWarping, CapsLieWithoutAFoldWithExactLengths)
{
  for (double degrees : { 30.0, 75.0, 105.0, 125.0, 150.0 })
  {
    for (int wires : { 0, 1, 2 })
    {
      const FlatteningResult result = flatten(cap(degrees * pi / 180.0, 12, wires));
      const QualitySummary& quality = result.pieces[0].quality;
      EXPECT_TRUE(quality.flipped.empty()) << degrees << " degrees, " << wires << " wires";
      EXPECT_LT(quality.maximumEdgeLengthError, 1e-10) << degrees << " degrees, " << wires;
    }
  }
}

TEST(ConvexWarping, TwoDiametersOfACapOf45DegreesComeToAMinimum)
{
  const FlatteningResult result = flatten(cap(0.25 * pi, 12, 2));
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LE(result.pieces[0].iterations, 30);
}

TEST(ConvexWarping, ACapWithoutWiresIsTheDiskWithItsBoundary)
{
  // The boundary of a surface of revolution keeps its length on a circle, and no other curve
  // of that length holds as much.
  const double angle = 5.0 * pi / 6.0;
  const FlatteningResult result = flatten(cap(angle, 12, 0));
  const double radius = 48.0 * 2.0 * std::sin(pi / 48.0) * std::sin(angle) / (2.0 * pi);
  double area = 0.0;
  for (const Triangle& t : result.cut->mesh.triangles())
  {
    const Point2 u = result.positions[t[1]] - result.positions[t[0]];
    const Point2 v = result.positions[t[2]] - result.positions[t[0]];
    area += 0.5 * (u.x() * v.y() - u.y() * v.x());
  }
  EXPECT_NEAR(area, pi * radius * radius, 0.01 * area);
}

TEST(ConvexWarping, SaysWhereTheSecondStartWasTheBetterOne)
{
  const FlatteningResult result = flatten(cap(2.6, 12, 1));
  const std::vector<std::string>& said = result.pieces[0].fallbacks;
  EXPECT_TRUE(std::any_of(said.begin(), said.end(),
    [](const std::string& text) { return text.find("convex map") != std::string::npos; }));
  EXPECT_TRUE(flatten(cap(0.4, 8, 1)).pieces[0].fallbacks.empty());
}
