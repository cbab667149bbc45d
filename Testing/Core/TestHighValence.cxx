// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with vertices of many triangles: domes with a pole, cones, fans.
#include "Flattened.h"

#include "MeshTriangles.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Meridians from a pole through parallels, sagging by a height.
TriangleMesh dome(Index meridians, Index parallels, double height)
{
  Points3 points{ { 0.0, 0.0, height } };
  for (Index j = 1; j <= parallels; ++j)
  {
    const double r = static_cast<double>(j) / parallels;
    for (Index i = 0; i < meridians; ++i)
    {
      const double a = 2.0 * pi * i / meridians;
      points.emplace_back(r * std::cos(a), r * std::sin(a), height * std::cos(1.3 * r));
    }
  }
  return { std::move(points), ringTriangles(meridians, parallels, meridians) };
}

/// Of the boundary edges, between the surface and the plane.
double greatestLengthError(const FlatteningResult& result)
{
  const TriangleMesh& mesh = result.cut->mesh;
  double greatest = 0.0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      const double flat = (result.positions[mesh.to(h)] - result.positions[mesh.from(h)]).norm();
      greatest = std::max(greatest, std::abs(flat - mesh.length(h)) / mesh.length(h));
    }
  }
  return greatest;
}
}

TEST(HighValence, DomesWithAPoleKeepTheirBoundarysLengthInEveryScheme)
{
  for (const auto& [meridians, parallels] :
    std::vector<std::pair<Index, Index>>{ { 13, 2 }, { 32, 6 }, { 100, 3 }, { 1000, 2 } })
  {
    const TriangleMesh mesh = dome(meridians, parallels, 0.4);
    for (Scheme scheme : { Scheme::Progressive, Scheme::Global, Scheme::Isometric })
    {
      const FlatteningResult result = flattenSurface(mesh, {}, withScheme(scheme), {});
      EXPECT_TRUE(result.status.ok()) << meridians << ": " << result.status.message;
      ASSERT_EQ(result.positions.size(), static_cast<std::size_t>(mesh.vertexCount()));
      EXPECT_LT(greatestLengthError(result), 1e-9) << meridians;
    }
  }
}

TEST(HighValence, ConesAndDomesOfTensOfThousandsOfTrianglesTakeLittleMemory)
{
  // All factors of a sound order take less; a dense front of the ring would take 7 GB.
  Execution execution;
  execution.factorMemory = 120'000'000;
  for (const auto& [meridians, parallels] :
    std::vector<std::pair<Index, Index>>{ { 30000, 1 }, { 5600, 5 } })
  {
    const TriangleMesh mesh = dome(meridians, parallels, 0.4);
    for (Scheme scheme : { Scheme::Global, Scheme::Isometric })
    {
      const FlatteningResult result = flattenSurface(mesh, {}, withScheme(scheme), execution);
      EXPECT_TRUE(result.status.ok()) << result.status.message;
      ASSERT_FALSE(result.positions.empty());
      EXPECT_LT(greatestLengthError(result), 1e-9);
    }
  }
}

TEST(HighValence, WiresByTheThousandMeetInOneVertex)
{
  // Half of the spokes of a flat half disc whose hub is on the boundary, in any numbering.
  constexpr Index spokes = 6000;
  Points3 points{ { 0.0, 0.0, 0.0 } };
  std::vector<FeatureCurve> curves;
  for (Index k = 0; k <= spokes; ++k)
  {
    const double a = pi * k / spokes;
    points.emplace_back(std::cos(a), std::sin(a), 0.0);
    if (k % 2 == 1)
    {
      curves.push_back(accessory("spoke " + std::to_string(k), { 0, k + 1 }));
    }
  }
  const TriangleMesh mesh(points, ringTriangles(spokes, 1, spokes + 1));
  Execution execution;
  execution.factorMemory = 50'000'000;
  for (Scheme scheme : { Scheme::Progressive, Scheme::Global, Scheme::Isometric })
  {
    const FlatteningResult result = flattenSurface(mesh, curves, withScheme(scheme), execution);
    EXPECT_TRUE(result.status.ok()) << result.status.message;
    ASSERT_FALSE(result.positions.empty());
    for (const Wire& wire : result.wires)
    {
      EXPECT_NEAR(wire.flatLength, wire.restLength, 1e-9 * wire.restLength);
    }
  }
}
