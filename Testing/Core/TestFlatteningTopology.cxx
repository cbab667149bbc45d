// SPDX-License-Identifier: BSD-3-Clause
// Vertices of very many triangles or wires; curves of other kinds are in
// Testing/Python/TestTopology.py.
#include "Flattened.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Meridians from a pole through parallels, sagging by a height.
TriangleMesh dome(Index meridians, Index parallels, double height)
{
  return disk(parallels, meridians, [height](double r, double turn) {
    return Point3(r * std::cos(turn), r * std::sin(turn), height * std::cos(1.3 * r));
  });
}
void expectExactLengths(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const std::vector<Scheme>& chosen, const Execution& execution = {})
{
  for (const Scheme scheme : chosen)
  {
    const FlatteningResult result = flattenSurface(mesh, curves, withScheme(scheme), execution);
    EXPECT_TRUE(result.status.ok()) << mesh.triangleCount() << ": " << result.status.message;
    ASSERT_EQ(result.positions.size(), static_cast<std::size_t>(mesh.vertexCount()));
    EXPECT_LT(worstLength(result), 1e-9) << mesh.triangleCount();
  }
}
}

TEST(HighValence, DomesWithAPoleKeepTheirBoundarysLengthInEveryScheme)
{
  for (const auto& [meridians, parallels] :
    std::vector<std::pair<Index, Index>>{ { 13, 2 }, { 32, 6 }, { 100, 3 }, { 1000, 2 } })
  {
    expectExactLengths(dome(meridians, parallels, 0.4), {},
      { Scheme::Progressive, Scheme::Global, Scheme::Isometric });
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
    expectExactLengths(
      dome(meridians, parallels, 0.4), {}, { Scheme::Global, Scheme::Isometric }, execution);
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
  Execution execution;
  execution.factorMemory = 50'000'000;
  for (Scheme scheme : { Scheme::Progressive, Scheme::Global, Scheme::Isometric })
  {
    const FlatteningResult result = flattenSurface(
      { points, ringTriangles(spokes, 1, spokes + 1) }, curves, withScheme(scheme), execution);
    EXPECT_TRUE(result.status.ok()) << result.status.message;
    ASSERT_FALSE(result.positions.empty());
    for (const Wire& wire : result.wires)
    {
      EXPECT_NEAR(wire.flatLength, wire.restLength, 1e-9 * wire.restLength);
    }
  }
}
