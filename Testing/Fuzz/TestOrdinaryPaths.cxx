// SPDX-License-Identifier: BSD-3-Clause
// Straight paths over sound surfaces of every shape.
#include "../Core/PathFacts.h"
#include "OrdinarySurface.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

#include <gtest/gtest.h>

using namespace hostile;
using namespace testmeshes;

TEST(OrdinaryFewPaths, AreStraightAndNoLongerThanByEdges)
{
  for (unsigned seed = 0; seed < 150; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> values(200);
    for (std::uint8_t& value : values)
    {
      value = static_cast<std::uint8_t>(random());
    }
    Bytes bytes(values.data(), values.size());
    const Specimen specimen = makeOrdinarySurface(bytes, { 1.0, 3000.0 });
    SCOPED_TRACE(specimen.name + ", seed " + std::to_string(seed));
    const PreparedSurface surface = prepareSurface(specimen.points, specimen.triangles);
    ASSERT_TRUE(surface.status.ok()) << surface.status.message;
    const TriangleMesh& mesh = surface.mesh;
    const PathGraph graph(mesh);
    for (int k = 0; k < 10; ++k)
    {
      const SurfacePoint from = randomPoint(mesh, random);
      const SurfacePoint to = randomPoint(mesh, random);
      const StraightPath path = straightPath(graph, from, to);
      ASSERT_TRUE(path.status.ok()) << path.status.message;
      EXPECT_TRUE(liesOn(mesh, path.path));
      EXPECT_LE(path.length, (1.0 + 1e-12) * lengthByEdges(mesh, from, to));
      EXPECT_GE(path.length, (1.0 - 1e-12) * (to.position - from.position).norm());
      EXPECT_LE(worstBend(mesh, path.path), 1e-9);
    }
  }
}
