// SPDX-License-Identifier: BSD-3-Clause
// What is kept from an earlier run changes no result; place, unit and numbering are in
// Testing/Python/TestTopology.py.
#include "Flattened.h"
#include "SameResult.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
Surface curvedCushion()
{
  return withCurves(cushion(24, 18, 0.4), { rowCurve(24, 7), columnCurve(24, 18, 9) });
}

/// A run with the cache gives the bits of a run without.
void expectTheSame(const Surface& surface, const FlatteningOptions& options, FlatteningCache& cache)
{
  const FlatteningResult with = flatten(surface, options, {}, &cache);
  const FlatteningResult without = flatten(surface, options);
  ASSERT_FALSE(without.status.refused());
  EXPECT_EQ(with.cut->originalVertex, without.cut->originalVertex);
  expectSame(with, without);
}

/// The same vertices in the same places, joined by other triangles, as many.
Surface otherDiagonals(const Surface& surface)
{
  Triangles triangles = surface.mesh.triangles();
  // A quad between the curves.
  const Triangle first = triangles[0];
  const Triangle second = triangles[1];
  triangles[0] = { first[0], first[1], second[2] };
  triangles[1] = { first[1], first[2], second[2] };
  Surface other = surface;
  other.mesh = TriangleMesh(surface.mesh.points(), std::move(triangles));
  return other;
}

/// The same triangles over the same vertices, one of which lies elsewhere.
Surface withPoint(const Surface& surface, Index vertex, const Point3& place)
{
  Points3 points = surface.mesh.points();
  points[vertex] = place;
  Surface other = surface;
  other.mesh = TriangleMesh(std::move(points), surface.mesh.triangles());
  return other;
}
}

TEST(FlatteningCache, NoticesWhatHasChanged)
{
  const FlatteningOptions options = optionsOf(Scheme::Global, InteriorMethod::AsRigidAsPossible);
  const Surface surface = curvedCushion();
  std::vector<Surface> changed(5, surface);
  changed[0].curves[0] = rowCurve(24, 8); // as long as the one before
  changed[1].curves[0].type = CurveType::Dart;
  changed[2].curves[1].type = CurveType::Seam;
  changed[3].curves[0].tolerance = 0.05;
  std::swap(changed[4].curves[0], changed[4].curves[1]);
  changed.push_back(otherDiagonals(surface));
  const Point3 inside = surface.mesh.point(30);
  changed.push_back(
    withPoint(surface, 30, { inside.x(), inside.y(), std::nextafter(inside.z(), 1.0) }));
  changed.push_back(withPoint(surface, 0, surface.mesh.point(0) + Point3(0.0, 0.0, 0.01)));
  for (const Surface& other : changed)
  {
    FlatteningCache cache;
    expectTheSame(surface, options, cache);
    expectTheSame(other, options, cache);
    expectTheSame(surface, options, cache);
  }
}

TEST(FlatteningCache, TellsSignedZerosApart)
{
  FlatteningCache cache;
  Surface surface = withCurves(flatPatch(6, 4), { rowCurve(6, 2) });
  surface = withPoint(surface, 0, { 0.0, 0.0, 0.0 });
  flatten(surface, {}, {}, &cache);
  surface = withPoint(surface, 0, { -0.0, 0.0, 0.0 });
  const FlatteningResult result = flatten(surface, {}, {}, &cache);
  EXPECT_TRUE(std::signbit(result.cut->mesh.point(0).x()));
}

TEST(FlatteningCache, CutsAgainOnlyWhereSurfaceOrCutsAreOthers)
{
  FlatteningCache cache;
  Surface surface = curvedCushion();
  const auto cutOf = [&](const FlatteningOptions& options) {
    return flatten(surface, options, {}, &cache).cut;
  };
  const FlatteningOptions options = optionsOf(Scheme::Global, InteriorMethod::Laplacian);
  const auto first = cutOf(options);
  surface.curves[0].type = CurveType::Key;
  surface.curves[0].keyShape = KeyShape::Straight;
  surface.curves[1].tolerance = 0.05;
  EXPECT_EQ(cutOf(optionsOf(Scheme::Isometric, InteriorMethod::AsRigidAsPossible)), first);
  surface.curves[0].type = CurveType::Dart;
  const auto second = cutOf(options);
  EXPECT_NE(second, first);
  EXPECT_EQ(first->mesh.vertexCount(), surface.mesh.vertexCount()) << "a result stays as it is";
  EXPECT_GT(second->mesh.vertexCount(), surface.mesh.vertexCount());
}

// Of a deep piece a vertex is named to cut to; its id may be that of no vertex after another cut.
TEST(FlatteningCache, ForecastsAreOfThePiecesThatAreThere)
{
  constexpr Index columns = 12;
  constexpr Index rows = 9;
  const std::vector<Scheme> schemes{ Scheme::Isometric, Scheme::Global,
    Scheme::LeastSquaresConformal };
  for (const double size : { 1.0, 1e-3, 1e4 })
  {
    Surface bag = patch(columns, rows, [=](double i, double j) -> Point3 {
      const double x = i / columns;
      const double y = j / rows;
      return size * Point3(x, y, 3.0 * std::sin(pi * x) * std::sin(pi * y));
    });
    Surface cut = withCurves(bag, { rowCurve(columns, 1, CurveType::Seam) });
    Surface turned = withCurves(bag, { columnCurve(columns, rows, columns - 1, CurveType::Seam) });
    FlatteningCache cache;
    for (const Scheme scheme : schemes)
    {
      const FlatteningOptions options = optionsOf(scheme, InteriorMethod::Laplacian);
      for (const Surface* surface : { &bag, &cut, &turned, &bag, &turned, &cut })
      {
        expectTheSame(*surface, options, cache);
      }
    }
    EXPECT_GT(flattenSurface(bag.mesh, {}, {}, {}).pieces.at(0).area.loss, 0.3);
  }
}

TEST(FlatteningCache, ServesAfterARefusalAndAfterARunThatWasCancelled)
{
  FlatteningCache cache;
  const Surface surface = curvedCushion();
  const FlatteningOptions options = optionsOf(Scheme::Global, InteriorMethod::AsRigidAsPossible);
  Surface refused = surface;
  refused.curves[0].vertices = { 0, 100 };
  expectTheSame(surface, options, cache);
  EXPECT_TRUE(flatten(refused, options, {}, &cache).status.refused());
  for (int questions = 0; questions < 12; ++questions)
  {
    expectTheSame(surface, options, cache);
    int left = questions;
    Execution execution;
    execution.cancel = [&left] { return left-- <= 0; };
    flatten(surface, options, execution, &cache);
  }
  expectTheSame(surface, options, cache);
}
