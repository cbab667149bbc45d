// SPDX-License-Identifier: BSD-3-Clause
// Random curves on random surfaces.
#include "ImprintTesting.h"

#include <random>

using namespace flattening;
using namespace imprinttesting;

namespace
{
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A point of the surface: a vertex, one on an edge, one inside, or one very near to the others.
Point3 randomPoint(const TriangleMesh& mesh, Random& random)
{
  const Index t = static_cast<Index>(random() % mesh.triangleCount());
  double u = uniform(random, 0.0, 1.0);
  double v = uniform(random, 0.0, 1.0);
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  switch (random() % 6)
  {
    case 0:
      u = v = 0.0;
      break;
    case 1:
      u = 0.0;
      break;
    case 2:
      u *= 3e-3;
      break;
    case 3:
      u *= 2e-3;
      v *= 2e-3;
      break;
    default:
      break;
  }
  const Triangle& c = mesh.triangle(t);
  return (1.0 - u - v) * mesh.point(c[0]) + u * mesh.point(c[1]) + v * mesh.point(c[2]);
}

TriangleMesh randomSurface(Random& random)
{
  const Index n = 2 + static_cast<Index>(random() % 9);
  const TriangleMesh flat = mapped(grid(n), [&random, n](const Point3& p) {
    const bool inner = p.x() > 0 && p.x() < n && p.y() > 0 && p.y() < n;
    const double d = inner ? 0.3 : 0.0;
    return Point3((p.x() + uniform(random, -d, d)) / n, (p.y() + uniform(random, -d, d)) / n, 0.0);
  });
  const double a = uniform(random, 0.0, 0.3);
  const double f = uniform(random, 0.5, 6.0);
  // Some are squeezed until their triangles are needles.
  const double squeeze = random() % 4 == 0 ? std::pow(10.0, uniform(random, -9.0, 0.0)) : 1.0;
  return mapped(flat, [a, f, squeeze](const Point3& p) {
    return Point3(p.x(), squeeze * p.y(), a * std::sin(f * p.x()) * std::cos(f * squeeze * p.y()));
  });
}
}

TEST(CurveImprint, NoRandomCurvesOnRandomSurfacesBreakTheMesh)
{
  Random random(20080301);
  int done = 0;
  const int cases = 600;
  for (int k = 0; k < cases && !HasFailure(); ++k)
  {
    SCOPED_TRACE("case " + std::to_string(k));
    const TriangleMesh mesh = k % 10 == 9 ? torus(9 + k % 7) : randomSurface(random);
    std::vector<Polyline> curves(1 + random() % 5);
    for (Polyline& curve : curves)
    {
      const std::size_t count = 2 + random() % 6;
      while (curve.points.size() < count)
      {
        curve.points.push_back(randomPoint(mesh, random));
      }
    }
    ImprintOptions options;
    options.snap = std::pow(10.0, uniform(random, -4.0, -0.8));
    const auto result = imprintCurves(mesh, curves, options);
    if (result.status.code == StatusCode::CurveLeavesSurface ||
      result.status.code == StatusCode::CurveTooShort)
    {
      continue;
    }
    ++done;
    expectSameSurface(mesh, result);
    const auto again = imprintCurves(mesh, curves, options);
    EXPECT_EQ(again.mesh.triangles(), result.mesh.triangles());
  }
  EXPECT_GT(done, cases / 2);
  RecordProperty("done", done);
}
