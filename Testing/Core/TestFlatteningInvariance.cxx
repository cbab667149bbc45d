// SPDX-License-Identifier: BSD-3-Clause
// What must not change a result: where the surface lies, its unit, the order of its parts, threads.
#include "Flattened.h"
#include "Renumbered.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
FlatteningOptions freeUnarranged()
{
  FlatteningOptions options = freeBoundary();
  options.arrange = false;
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

TEST(FlatteningInvariance, NeitherPlaceNorUnitNorOrderOfCurvesChangeAnything)
{
  const Surface surface = garment();
  struct Change
  {
    Surface surface;
    double scale;
  };
  std::vector<Change> changes{ { movedRigidly(surface), 1.0 }, { surface, 1.0 } };
  std::vector<FeatureCurve>& curves = changes.back().surface.curves;
  std::reverse(curves.begin(), curves.end());
  for (FeatureCurve& curve : curves)
  {
    std::reverse(curve.vertices.begin(), curve.vertices.end());
  }
  for (const double scale : { 1e-6, 1e-3, 1e6 })
  {
    changes.push_back({ surface, scale });
    changes.back().surface.mesh =
      moved(surface.mesh, [&](const Point3& p) -> Point3 { return scale * p; });
  }
  for (std::size_t k = 0; k < changes.size(); ++k)
  {
    SCOPED_TRACE(k);
    for (const FlatteningOptions& options : schemes)
    {
      expectSame(flatten(surface, options), flatten(changes[k].surface, options),
        identity(surface.mesh.triangleCount()), changes[k].scale, 1e-9);
    }
  }
}

TEST(FlatteningInvariance, NumbersOfVerticesAndTrianglesChangeNothing)
{
  const Surface surface = garment();
  const Surface otherVertices = withVertices(surface, shuffled(surface.mesh.vertexCount()));
  const Indices order = shuffled(surface.mesh.triangleCount());
  Triangles triangles(order.size());
  for (Index t = 0; t < surface.mesh.triangleCount(); ++t)
  {
    triangles[order[t]] = surface.mesh.triangle(t);
  }
  Surface otherTriangles = surface;
  otherTriangles.mesh = TriangleMesh(surface.mesh.points(), triangles);
  for (const FlatteningOptions& options : schemes)
  {
    const FlatteningResult result = flatten(surface, options);
    expectSame(
      result, flatten(otherVertices, options), identity(surface.mesh.triangleCount()), 1.0, 1e-9);
    // The progressive scheme breaks ties by the number of a patch.
    if (options.scheme != Scheme::Progressive)
    {
      expectSame(result, flatten(otherTriangles, options), order, 1.0, 1e-9);
    }
  }
}
