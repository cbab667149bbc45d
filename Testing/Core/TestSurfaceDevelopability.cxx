// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/SurfaceDevelopability.h"

#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace flattening;
using namespace testmeshes;

namespace
{
std::vector<double> developability(const TriangleMesh& mesh)
{
  return surfaceDevelopability(mesh, cornerAngles(mesh, {}));
}
}

TEST(SurfaceDevelopability, IsZeroOnDevelopableSurfaces)
{
  for (const Surface& surface : { flatPatch(7, 5), cone(9, 6), cylinder(8, 5) })
  {
    for (double value : developability(surface.mesh))
    {
      EXPECT_LT(value, 1e-13);
    }
  }
}

TEST(SurfaceDevelopability, SumsToWhatGaussAndBonnetSayOfAConvexSurface)
{
  const TriangleMesh mesh = quarterSphere().mesh;
  const std::vector<double> values = developability(mesh);
  double turning = 0.0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.onBoundary(v))
    {
      EXPECT_EQ(values[v], 0.0);
      double sum = 0.0;
      for (Index h = mesh.outgoing(v); h != none; h = mesh.counterClockwise(h))
      {
        sum += mesh.angle(h);
      }
      turning += pi - sum;
    }
  }
  EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0) + turning, 2.0 * pi, 1e-13);
}

TEST(SurfaceDevelopability, MeasuresASaddleAsMuchAsAPeak)
{
  // Six triangles around a vertex whose neighbours alternate above and below.
  Points3 points{ Point3::Zero() };
  Triangles triangles;
  for (Index k = 0; k < 6; ++k)
  {
    points.push_back(
      Point3(std::cos(k * pi / 3.0), std::sin(k * pi / 3.0), k % 2 == 0 ? 0.5 : -0.5));
    triangles.push_back({ 0, 1 + k, 1 + (k + 1) % 6 });
  }
  const double expected = 6.0 * std::acos((0.5 - 0.25) / 1.25) - 2.0 * pi;
  ASSERT_GT(expected, 1.0);
  EXPECT_NEAR(developability(TriangleMesh(points, triangles))[0], expected, 1e-14);
}
