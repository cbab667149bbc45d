// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SurfaceCoarsening.h"

#include "Suggestion/PieceSurface.h"
#include "SuggestionTesting.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A dome over the unit square of 24 x 24 squares.
TriangleMesh dome()
{
  return heightField(24, [](double x, double y) {
    return 0.4 * (1.0 - x * x) * (1.0 - y * y);
  }).mesh;
}

double boundaryLength(const TriangleMesh& mesh)
{
  double length = 0.0;
  for (const Indices& loop : mesh.boundaryLoops())
  {
    for (Index h : loop)
    {
      length += mesh.length(h);
    }
  }
  return length;
}

double rigidEnergy(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves)
{
  const FlatteningResult result = flattenSurface(mesh, curves, {}, {});
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  return result.pieces.front().quality.rigidEnergy;
}
}

TEST(SurfaceCoarsening, KeepsBoundaryAndEdgesBetweenKeptVertices)
{
  const TriangleMesh mesh = dome();
  std::vector<char> kept(mesh.vertexCount(), 0);
  for (Index j = 0; j <= 24; ++j)
  {
    kept[j * 25 + 12] = 1;
  }
  const CoarseSurface coarse = coarsened(mesh, kept, 400);
  EXPECT_LE(coarse.mesh.triangleCount(), 400);
  EXPECT_GE(coarse.mesh.triangleCount(), 390);
  EXPECT_EQ(eulerCharacteristic(coarse.mesh), 1);
  EXPECT_NEAR(boundaryLength(coarse.mesh), boundaryLength(mesh), 1e-12);
  Indices number(mesh.vertexCount(), none);
  for (std::size_t v = 0; v < coarse.vertices.size(); ++v)
  {
    number[coarse.vertices[v]] = static_cast<Index>(v);
    EXPECT_EQ(coarse.mesh.point(static_cast<Index>(v)), mesh.point(coarse.vertices[v]));
  }
  for (Index j = 0; j < 24; ++j)
  {
    const Index a = number[j * 25 + 12];
    const Index b = number[(j + 1) * 25 + 12];
    ASSERT_NE(a, none);
    ASSERT_NE(b, none);
    EXPECT_NE(coarse.mesh.find(a, b), none) << j;
  }
}

TEST(SurfaceCoarsening, LeavesAFlatSurfaceFlatAndOfTheSameArea)
{
  const Surface flat = flatPatch(20, 15);
  const CoarseSurface coarse = coarsened(flat.mesh, std::vector<char>(flat.mesh.vertexCount()), 1);
  EXPECT_LT(coarse.mesh.triangleCount(), flat.mesh.triangleCount() / 3);
  EXPECT_NEAR(coarse.mesh.area(), flat.mesh.area(), 1e-9 * flat.mesh.area());
}

TEST(SurfaceCoarsening, ACylinderFlattensAsWellCoarse)
{
  // Where curvature moved about, coarse triangles of a cylinder would have no common plane.
  const TriangleMesh mesh = cylinder(24, 16).mesh;
  const CoarseSurface coarse = coarsened(mesh, std::vector<char>(mesh.vertexCount()), 300);
  EXPECT_LT(coarse.mesh.triangleCount(), 320);
  EXPECT_LT(rigidEnergy(coarse.mesh, {}), 1e-4);
}

TEST(SurfaceCoarsening, ACoarsePieceIsDistortedAlike)
{
  const TriangleMesh mesh = dome();
  const CoarseSurface coarse = coarsened(mesh, std::vector<char>(mesh.vertexCount()), 500);
  const double fine = rigidEnergy(mesh, {});
  EXPECT_NEAR(rigidEnergy(coarse.mesh, {}), fine, 0.1 * fine);
}

TEST(SurfaceCoarsening, APairOfCutsMeetsInThePlaneWhenItIsMoved)
{
  // No vertex of the dome lies in the plane, and where the pair meets is only near to it.
  const TriangleMesh mesh =
    heightField(25, [](double x, double y) { return 0.4 * (1.0 - x * x) * (1.0 - y * y); }).mesh;
  const Point3 middle(1e-3, 0.3, 0.5);
  const Points3 right{ { 0.9, 0.3, 0.1 }, { 0.4, 0.4, 0.4 }, middle };
  const Points3 left{ { -0.9, 0.3, 0.1 }, { -0.4, 0.4, 0.4 }, middle };
  std::optional<SurfaceMirror> mirror = SurfaceMirror({ { 1.0, 0.0, 0.0 }, 0.0, 0.0 });
  const std::vector<SuggestedCurve> cuts =
    movedCuts(mesh, mirror, { proposedCut(right), proposedCut(left, CurveType::Seam, 0) });
  ASSERT_EQ(cuts.size(), 2u);
  EXPECT_LE(mirror->error, SurfaceMirror::exact);
  EXPECT_EQ(cuts[0].curve.points.back(), cuts[1].curve.points.back());
  EXPECT_NEAR(cuts[0].curve.points.back().x(), 1e-3, 1e-6);
}

TEST(SurfaceCoarsening, CutsThatRunAlongEachOtherPartTheSurfaceAsBefore)
{
  const TriangleMesh mesh = heightField(20, [](double, double) { return 0.0; }).mesh;
  const auto along = [](std::initializer_list<std::pair<double, double>> places) {
    Points3 points;
    for (const auto& [x, y] : places)
    {
      points.emplace_back(x, y, 0.0);
    }
    return proposedCut(std::move(points));
  };
  std::optional<SurfaceMirror> mirror;
  const std::vector<SuggestedCurve> cuts = movedCuts(mesh, mirror,
    { along({ { -1.0, 0.0 }, { 1.0, 0.0 } }),
      along({ { -1.0, 0.5 }, { -0.5, 0.0 }, { 0.5, 0.0 }, { 1.0, -0.5 } }),
      along({ { 0.0, 0.0 }, { 0.0, 1.0 } }) });
  double length = 0.0;
  for (const SuggestedCurve& cut : cuts)
  {
    length += polylineLength(cut.curve.points);
  }
  EXPECT_NEAR(length, 3.0 + std::sqrt(2.0), 1e-9);
  const ImprintedSurface surface = imprintCurves(mesh, linesOf(cuts), {});
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  std::vector<double> areas(cut.pieceCount, 0.0);
  for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
  {
    areas[cut.pieceOfTriangle[t]] += cut.mesh.area(t);
  }
  std::sort(areas.begin(), areas.end());
  ASSERT_EQ(areas.size(), 5u);
  EXPECT_NEAR(areas[0], 0.125, 1e-9);
  EXPECT_NEAR(areas[1], 0.125, 1e-9);
  EXPECT_NEAR(areas[2], 0.875, 1e-9);
  EXPECT_NEAR(areas[3], 1.0, 1e-9);
  EXPECT_NEAR(areas[4], 1.875, 1e-9);
}

TEST(PieceSurface, FlattensAsThePieceDoes)
{
  const TriangleMesh mesh = dome();
  // A seam up the middle, on its right a dart from the hem and a girth that the seam divides.
  const std::vector<Polyline> curves{ lineOver(
                                        mesh, columnCurve(24, 24, 12).vertices, CurveType::Seam),
    lineOver(mesh, columnCurve(24, 8, 18).vertices, CurveType::Dart),
    lineOver(mesh, rowCurve(24, 16).vertices) };
  const ImprintedSurface surface = imprintCurves(mesh, curves, {});
  ASSERT_TRUE(surface.status.ok());
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  const std::vector<PieceSurface> pieces = pieceSurfaces(surface, cut);
  ASSERT_EQ(pieces.size(), 2u);
  const FlatteningResult whole = flattenSurface(surface.mesh, surface.curves, {}, {});
  for (std::size_t p = 0; p < 2; ++p)
  {
    const double energy = whole.pieces[p].quality.rigidEnergy;
    EXPECT_NEAR(rigidEnergy(pieces[p].mesh, pieces[p].curves), energy, 1e-9 * energy);
    const PieceSurface coarse = coarsened(pieces[p], 300);
    EXPECT_LE(coarse.mesh.triangleCount(), 300);
    EXPECT_NEAR(rigidEnergy(coarse.mesh, coarse.curves), energy, 0.25 * energy);
  }
  EXPECT_EQ(pieces[0].curves.size() + pieces[1].curves.size(), 3u);
}
