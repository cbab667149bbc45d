// SPDX-License-Identifier: BSD-3-Clause
// What must not change a result: where the surface lies, its unit, the order of its parts, threads.
#include "Flattened.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

using namespace flattening;
using namespace testmeshes;

namespace
{
FlatteningOptions freeUnarranged()
{
  FlatteningOptions options = optionsOf(Scheme::Isometric, FlatteningOptions().interior.method);
  options.boundary = BoundaryMode::Free;
  options.isometric.energy.kind = DistortionEnergyKind::Automatic;
  return options;
}

/// What a user gets who chooses nothing, with a free boundary as well, and the paper's two schemes.
const std::vector<FlatteningOptions> schemes{ optionsOf(Scheme::Isometric,
                                                FlatteningOptions().interior.method),
  freeUnarranged(), optionsOf(Scheme::Global), optionsOf(Scheme::Progressive) };

/// Two pieces with a dart, a key, an accessory curve and a floating one.
Surface garment()
{
  Surface surface = cushion(10, 8, 0.15);
  surface.curves = { columnCurve(10, 8, 6, CurveType::Seam),
    curveOf(CurveType::Dart, "dart", { 2, 13, 24 }), rowCurve(10, 5, CurveType::Key),
    columnCurve(10, 8, 4), accessory("floating", { 30, 31, 42 }) };
  surface.curves[2].keyShape = KeyShape::Straight;
  return surface;
}

/// Flat corners of every triangle, which needs no numbering of the copies of vertices.
Points2 corners(const FlatteningResult& result, const Indices& triangleOrder, Index piece)
{
  Points2 points;
  for (const Index t : triangleOrder)
  {
    if (result.cut->pieceOfTriangle[t] == piece)
    {
      for (const Index v : result.cut->mesh.triangle(t))
      {
        points.push_back(result.positions[v]);
      }
    }
  }
  return points;
}

Indices identity(Index count)
{
  Indices order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// A seeded order that is the same with every library.
Indices shuffled(Index count)
{
  Indices order = identity(count);
  std::mt19937 random(5);
  for (Index k = count - 1; k > 0; --k)
  {
    std::swap(order[k], order[random() % (k + 1)]);
  }
  return order;
}

/// \param order triangle k of `first` is triangle order[k] of `second`.
void expectSame(const FlatteningResult& first, const FlatteningResult& second, const Indices& order,
  double scale, double tolerance)
{
  ASSERT_FALSE(first.status.refused());
  ASSERT_FALSE(second.status.refused());
  EXPECT_EQ(first.status.code, second.status.code);
  ASSERT_EQ(first.pieces.size(), second.pieces.size());
  for (Index p = 0; p < first.cut->pieceCount; ++p)
  {
    Points2 a = corners(first, identity(first.cut->mesh.triangleCount()), p);
    Index other = none;
    for (Index t = 0; t < first.cut->mesh.triangleCount() && other == none; ++t)
    {
      other = first.cut->pieceOfTriangle[t] == p ? second.cut->pieceOfTriangle[order[t]] : none;
    }
    Points2 b = corners(second, order, other);
    for (Point2& point : b)
    {
      point /= scale;
    }
    ASSERT_EQ(a.size(), b.size());
    EXPECT_LT(rigidDistance(a, b), tolerance);
    EXPECT_NEAR(first.pieces[p].objective, second.pieces[other].objective, tolerance);
  }
}
}

TEST(FlatteningInvariance, RigidMotionsChangeNothing)
{
  const Surface surface = garment();
  const Surface moved = movedRigidly(surface);
  for (const FlatteningOptions& options : schemes)
  {
    expectSame(flatten(surface, options), flatten(moved, options),
      identity(surface.mesh.triangleCount()), 1.0, 1e-9);
  }
}

TEST(FlatteningInvariance, TheUnitOfLengthChangesNothing)
{
  const Surface surface = garment();
  for (const double scale : { 1e-6, 1e-3, 1e6 })
  {
    Surface scaled = surface;
    scaled.mesh = moved(surface.mesh, [&](const Point3& p) -> Point3 { return scale * p; });
    for (const FlatteningOptions& options : schemes)
    {
      expectSame(flatten(surface, options), flatten(scaled, options),
        identity(surface.mesh.triangleCount()), scale, 1e-9);
    }
  }
}

TEST(FlatteningInvariance, TheNumbersOfVerticesChangeNothing)
{
  const Surface surface = garment();
  const Indices number = shuffled(surface.mesh.vertexCount());
  Surface renumbered = surface;
  Points3 points(number.size());
  Triangles triangles = surface.mesh.triangles();
  for (Index v = 0; v < surface.mesh.vertexCount(); ++v)
  {
    points[number[v]] = surface.mesh.point(v);
  }
  for (Triangle& t : triangles)
  {
    for (Index& v : t)
    {
      v = number[v];
    }
  }
  for (FeatureCurve& curve : renumbered.curves)
  {
    for (Index& v : curve.vertices)
    {
      v = number[v];
    }
  }
  renumbered.mesh = TriangleMesh(points, triangles);
  for (const FlatteningOptions& options : schemes)
  {
    expectSame(flatten(surface, options), flatten(renumbered, options),
      identity(surface.mesh.triangleCount()), 1.0, 1e-9);
  }
}

TEST(FlatteningInvariance, TheNumbersOfTrianglesChangeNothing)
{
  // The progressive scheme, the last, breaks ties by the number of a patch.
  const Surface surface = garment();
  const Indices number = shuffled(surface.mesh.triangleCount());
  Triangles triangles(number.size());
  for (Index t = 0; t < surface.mesh.triangleCount(); ++t)
  {
    triangles[number[t]] = surface.mesh.triangle(t);
  }
  Surface renumbered = surface;
  renumbered.mesh = TriangleMesh(surface.mesh.points(), triangles);
  for (const FlatteningOptions& options : { schemes[0], schemes[1], schemes[2] })
  {
    expectSame(flatten(surface, options), flatten(renumbered, options), number, 1.0, 1e-9);
  }
}

TEST(FlatteningInvariance, TheOrderAndDirectionOfCurvesChangeNothing)
{
  const Surface surface = garment();
  Surface other = surface;
  std::reverse(other.curves.begin(), other.curves.end());
  for (FeatureCurve& curve : other.curves)
  {
    std::reverse(curve.vertices.begin(), curve.vertices.end());
  }
  for (const FlatteningOptions& options : schemes)
  {
    expectSame(flatten(surface, options), flatten(other, options),
      identity(surface.mesh.triangleCount()), 1.0, 1e-9);
  }
}
