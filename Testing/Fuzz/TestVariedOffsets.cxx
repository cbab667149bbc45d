// SPDX-License-Identifier: BSD-3-Clause
// Offsets of curves over surfaces of every shape, coarse and fine, and in every unit.
#include "../Core/PathFacts.h"
#include "HostileSurface.h"
#include "Paths/PathDistance.h"
#include "Paths/PathOffset.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"
#include "Surface/SurfacePreparation.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace hostile;
using namespace testmeshes;

namespace
{
constexpr double closely = 1e-7;
const double tangent = 1.0 / std::cos(pi / 72.0); // of an arc of 5 degrees, at its end

double lengthOfAll(const PathOffset& offset)
{
  double length = 0.0;
  for (const SurfacePath& part : offset.parts)
  {
    length += lengthOf(part);
  }
  return length;
}

/// \return how many points were looked at
int expectOffset(const PathGraph& graph, const SurfacePath& path, double distance)
{
  const TriangleMesh& mesh = graph.mesh();
  const double reach = std::abs(distance);
  const PathOffset offset = offsetPath(graph, path, distance);
  EXPECT_TRUE(offset.status.ok() || offset.status.code == StatusCode::CurveLeavesSurface)
    << offset.status.message;
  int points = 0;
  for (const SurfacePath& part : offset.parts)
  {
    EXPECT_TRUE(liesOn(mesh, part));
    EXPECT_GT(lengthOf(part), 0.0);
    const std::size_t step = 1 + part.points.size() / 6;
    for (std::size_t i = 0; i < part.points.size(); i += step)
    {
      EXPECT_GE(distanceFrom(graph, path, part.points[i]).way.length, reach * (1.0 - closely));
      EXPECT_LE(gapInSpace(path, part.points[i].position), reach * tangent);
      ++points;
    }
  }
  return points;
}
}

TEST(VariedFewOffsets, KeepTheirDistanceOnEverySurface)
{
  int points = 0;
  for (unsigned seed = 0; seed < 120; ++seed)
  {
    std::mt19937 random(seed);
    const Specimen specimen = makeVariedSurface(random);
    SCOPED_TRACE(specimen.name + ", seed " + std::to_string(seed));
    const PreparedSurface surface =
      prepareSurface(specimen.points, specimen.triangles, CoincidentPoints::Keep);
    ASSERT_TRUE(surface.status.ok()) << surface.status.message;
    const PathGraph graph(surface.mesh);
    for (int k = 0; k < 4; ++k)
    {
      // There and back, closed and open.
      std::vector<SurfacePoint> nodes;
      for (int n = 0; n < 2 + k % 3; ++n)
      {
        nodes.push_back(randomPoint(surface.mesh, random));
      }
      if (k == 3)
      {
        nodes.push_back(nodes.front());
      }
      SurfacePath path{ { nodes.front() }, {}, true };
      for (std::size_t n = 1; n < nodes.size(); ++n)
      {
        const StraightPath leg = straightPath(graph, nodes[n - 1], nodes[n]);
        if (!leg.status.refused())
        {
          append(path, leg.path);
        }
        else
        {
          path.triangles.clear();
          break;
        }
      }
      if (path.triangles.empty() || !(lengthOf(path) > 0.0))
      {
        continue;
      }
      const double share =
        std::pow(10.0, std::uniform_real_distribution<double>(-2.0, 0.0)(random));
      const double reach = share * lengthOf(path);
      points += expectOffset(graph, path, k % 2 == 0 ? reach : -reach);
      const PathOffset one = offsetPath(graph, path, reach);
      const PathOffset other = offsetPath(graph, reversed(path), -reach);
      EXPECT_NEAR(lengthOfAll(one), lengthOfAll(other), 1e-3 * reach);
    }
  }
  EXPECT_GT(points, 1000);
}
