// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/CurveImprint.h"
#include "MeshTriangles.h"
#include "Surface/SurfacePreparation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// Surfaces to imprint curves on, and what holds for every imprint.
namespace imprinttesting
{
using namespace flattening;

/// A flat grid of n x n unit squares, each cut along its diagonal; vertex (i, j) is j (n + 1) + i.
inline TriangleMesh grid(Index n)
{
  Points3 points;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      points.push_back(Point3(i, j, 0.0));
    }
  }
  return prepareSurface(points, testmeshes::gridTriangles(n, n)).mesh;
}

inline Polyline polyline(Points3 points)
{
  Polyline result;
  result.points = std::move(points);
  for (std::size_t i = 0; i < result.points.size(); ++i)
  {
    result.pointIds.push_back(static_cast<Index>(100 + i));
  }
  return result;
}

inline double length(const TriangleMesh& mesh, const Indices& chain)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    sum += (mesh.point(chain[i]) - mesh.point(chain[i - 1])).norm();
  }
  return sum;
}

/// A surface z = f over the points of a grid, or any other map of them.
template <typename Map>
inline TriangleMesh mapped(const TriangleMesh& mesh, Map map)
{
  Points3 points = mesh.points();
  for (Point3& p : points)
  {
    p = map(p);
  }
  PreparedSurface surface = prepareSurface(points, mesh.triangles(), CoincidentPoints::Join);
  EXPECT_TRUE(surface.status.ok()) << surface.status.message;
  return surface.mesh;
}

/// What holds for every imprint: the same surface, as a valid mesh, with each curve on its edges.
inline void expectSameSurface(const TriangleMesh& before, const ImprintedSurface& after)
{
  ASSERT_TRUE(after.status.ok()) << after.status.message;
  const TriangleMesh& mesh = after.mesh;
  const PreparedSurface valid =
    prepareSurface(mesh.points(), mesh.triangles(), CoincidentPoints::Join);
  ASSERT_TRUE(valid.status.ok()) << valid.status.message;
  EXPECT_TRUE(valid.reversedTriangles.empty());
  EXPECT_EQ(valid.mesh.vertexCount(), mesh.vertexCount());
  EXPECT_EQ(eulerCharacteristic(mesh), eulerCharacteristic(before));
  EXPECT_EQ(mesh.boundaryLoops().size(), before.boundaryLoops().size());

  ASSERT_EQ(after.originalTriangle.size(), mesh.triangles().size());
  std::vector<double> area(before.triangleCount(), 0.0);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Index whole = after.originalTriangle[t];
    ASSERT_TRUE(whole >= 0 && whole < before.triangleCount());
    area[whole] += mesh.area(t);
  }
  for (Index t = 0; t < before.triangleCount(); ++t)
  {
    // Rounding of a triangle's own coordinates is all that may change its area.
    double longest = 0.0;
    double size = 0.0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      longest = std::max(longest, before.length(h));
      size = std::max(size, before.point(before.from(h)).norm());
    }
    EXPECT_NEAR(area[t], before.area(t), 1e-12 * before.area(t) + 1e-14 * longest * size);
  }

  ASSERT_EQ(after.vertexSource.size(), mesh.points().size());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const VertexSource& source = after.vertexSource[v];
    Point3 mean = Point3::Zero();
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_GE(source.weights[k], -1e-15);
      sum += source.weights[k];
      mean += source.weights[k] * before.point(source.vertices[k]);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_LE((mean - mesh.point(v)).norm(), 1e-15 * (1.0 + mean.norm()));
    if (v < before.vertexCount())
    {
      EXPECT_EQ(mesh.point(v), before.point(v));
    }
  }

  for (const FeatureCurve& curve : after.curves)
  {
    ASSERT_GE(curve.vertices.size(), 2u);
    for (std::size_t i = 1; i < curve.vertices.size(); ++i)
    {
      const Index a = curve.vertices[i - 1];
      const Index b = curve.vertices[i];
      EXPECT_TRUE(mesh.find(a, b) != none || mesh.find(b, a) != none);
    }
  }
}

inline double smallestAngle(const TriangleMesh& mesh)
{
  double least = pi;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    least = std::min(least, mesh.angle(h));
  }
  return least;
}

/// Half a cylinder of radius one and height two, n by n.
inline TriangleMesh halfCylinder(Index n)
{
  return mapped(grid(n), [n](const Point3& p) {
    const double angle = pi * p.x() / n;
    return Point3(std::cos(angle), std::sin(angle), 2.0 * p.y() / n);
  });
}

/// A closed tube bent to a ring: a torus of radii two and one half.
inline TriangleMesh torus(Index n)
{
  return mapped(grid(n), [n](const Point3& p) {
    const double u = 2.0 * pi * (static_cast<Index>(p.x()) % n) / n;
    const double v = 2.0 * pi * (static_cast<Index>(p.y()) % n) / n;
    const double r = 2.0 + 0.5 * std::cos(v);
    return Point3(r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v));
  });
}
}
