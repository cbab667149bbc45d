// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with pieces that no method can lay flat: without boundary, or with handles.
#include "Cut/PieceTopology.h"
#include "Flattened.h"
#include "SameResult.h"

#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A button: closed, of four triangles.
TriangleMesh tetrahedron()
{
  return TriangleMesh({ Point3(0, 0, 9), Point3(1, 0, 9), Point3(0, 1, 9), Point3(0, 0, 10) },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
}

constexpr Index ringSize = 8;

TriangleMesh ring()
{
  return torus(ringSize, 3.0);
}

TriangleMesh torusWithAHole()
{
  Triangles triangles = ring().triangles();
  triangles.pop_back();
  return TriangleMesh(ring().points(), std::move(triangles));
}

Surface partOf(TriangleMesh mesh)
{
  return { std::move(mesh), {}, {} };
}

/// Curves of every type, so that what refers to vertices, edges and pieces has something to say.
Surface shirt()
{
  Surface surface = withCurves(
    cushion(8, 6, 0.3), { rowCurve(8, 3, CurveType::Key), columnCurve(8, 6, 4, CurveType::Seam) });
  surface.curves[0].keyShape = KeyShape::Straight;
  return surface;
}

FlatteningOptions skipping(Scheme scheme = Scheme::Isometric)
{
  FlatteningOptions options = withScheme(scheme);
  options.interior.method = InteriorMethod::AsRigidAsPossible;
  options.skipClosed = true;
  return options;
}

/// A torus that a seam around the quads (0, 0) to (1, 1) divides into a disc and a part with a
/// handle, and an accessory curve through both.
Surface seamedTorus()
{
  const auto at = [](Index i, Index j) { return i * ringSize + j; };
  return withCurves(partOf(ring()),
    { curveOf(CurveType::Seam, "around",
        { at(0, 0), at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1),
          at(0, 0) }),
      accessory("through", { at(0, 1), at(1, 1), at(2, 1), at(3, 1), at(4, 1) }),
      accessory("elsewhere", { at(4, 4), at(5, 4) }) });
}
}

TEST(PieceTopology, AllPiecesThatCannotBeLaidFlatAreNamedInOneMessage)
{
  const Surface surface = together({ shirt(), partOf(tetrahedron()), partOf(torusWithAHole()),
    shirt(), partOf(ring()), partOf(tetrahedron()) });
  const Index shirtSize = 2 * 8 * 6;
  const Index torusSize = 2 * ringSize * ringSize;
  const Index button = shirtSize;
  const Index holed = button + 4;
  const Index ring = holed + torusSize - 1 + shirtSize;
  const Index lastButton = ring + torusSize;
  for (const Scheme scheme :
    { Scheme::Progressive, Scheme::Global, Scheme::Isometric, Scheme::LeastSquaresConformal })
  {
    FlatteningOptions options = skipping(scheme);
    options.skipClosed = false;
    const FlatteningResult result = flatten(surface, options);
    EXPECT_EQ(result.status.code, StatusCode::ClosedSurface);
    EXPECT_EQ(result.status.ids,
      (ElementIds{ ElementKind::Cells, Indices{ button, holed, ring, lastButton } }));
    for (const std::int64_t id : result.status.ids.values)
    {
      EXPECT_NE(result.status.message.find(std::to_string(id)), std::string::npos)
        << result.status.message;
    }
    EXPECT_TRUE(result.positions.empty());
    EXPECT_TRUE(result.leftOut.empty());
  }
}

TEST(PieceTopology, ARefusalCostsNoFlattening)
{
  const Surface surface = together({ shirt(), shirt(), partOf(tetrahedron()) });
  std::set<std::string> phases;
  Execution execution;
  execution.progress = [&phases](double, const char* phase) { phases.insert(phase); };
  const FlatteningResult refused = flatten(surface, {}, execution);
  EXPECT_EQ(refused.status.code, StatusCode::ClosedSurface);
  EXPECT_EQ(phases, std::set<std::string>{ "Cutting darts and seams" });
}

TEST(PieceTopology, PiecesWithHandlesAloneAreRefusedForTheirHandles)
{
  const FlatteningResult result =
    flatten(together({ shirt(), partOf(torusWithAHole()) }), FlatteningOptions());
  EXPECT_EQ(result.status.code, StatusCode::Handle);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::Cells, Indices{ 2 * 8 * 6 } }));
}

TEST(PieceTopology, WhatIsSkippedChangesNothingOfTheRest)
{
  const Surface surface = together(
    { partOf(tetrahedron()), shirt(), partOf(torusWithAHole()), shirt(), partOf(tetrahedron()) });
  const Surface rest = together({ shirt(), shirt() });
  for (const Scheme scheme :
    { Scheme::Progressive, Scheme::Global, Scheme::Isometric, Scheme::LeastSquaresConformal })
  {
    const FlatteningResult result = flatten(surface, skipping(scheme));
    expectSame(result, flatten(rest, skipping(scheme)));
    ASSERT_EQ(result.leftOut.size(), 3U);
    EXPECT_EQ(result.leftOut[0].triangle, 0);
    EXPECT_EQ(result.leftOut[0].triangles, 4);
    EXPECT_TRUE(result.leftOut[0].closed);
    EXPECT_EQ(result.leftOut[0].handles, 0);
    EXPECT_EQ(result.leftOut[1].triangle, 4 + 2 * 8 * 6);
    EXPECT_FALSE(result.leftOut[1].closed);
    EXPECT_EQ(result.leftOut[1].handles, 1);
  }
}

TEST(PieceTopology, WhereNothingWouldRemainTheSurfaceIsRefused)
{
  const FlatteningResult result =
    flatten(together({ partOf(tetrahedron()), partOf(torusWithAHole()) }), skipping());
  EXPECT_EQ(result.status.code, StatusCode::ClosedSurface);
  EXPECT_EQ(result.status.ids, (ElementIds{ ElementKind::Cells, Indices{ 0, 4 } }));
  for (const SuggestedRemedy& suggested : result.status.remedies)
  {
    EXPECT_NE(suggested.remedy, Remedy::SkipClosed);
  }
}

TEST(PieceTopology, CurvesCountAsFarAsTheyRunOnWhatIsKept)
{
  const Surface surface = seamedTorus();
  FlatteningOptions options = skipping();
  const FlatteningResult result = flatten(surface, options);
  ASSERT_FALSE(result.status.refused()) << result.status.message;
  ASSERT_EQ(result.pieces.size(), 1U);
  EXPECT_EQ(result.pieces[0].triangles, 8) << "two by two quads";
  ASSERT_EQ(result.leftOut.size(), 1U);
  EXPECT_EQ(result.leftOut[0].handles, 1);
  EXPECT_EQ(result.leftOut[0].triangles, 2 * ringSize * ringSize - 8);
  EXPECT_TRUE(result.cut->seamPairs.empty()) << "the other side is not there";

  const auto lengthOf = [&surface](const FeatureCurve& curve, std::size_t edges) {
    double length = 0.0;
    for (std::size_t k = 0; k < edges; ++k)
    {
      length +=
        (surface.mesh.point(curve.vertices[k + 1]) - surface.mesh.point(curve.vertices[k])).norm();
    }
    return length;
  };
  ASSERT_EQ(result.curves.size(), 3U);
  EXPECT_NEAR(result.curves[0].restLength, lengthOf(surface.curves[0], 8), 1e-12);
  EXPECT_NEAR(result.curves[0].flatLength, lengthOf(surface.curves[0], 8), 1e-9);
  EXPECT_NEAR(result.curves[1].restLength, lengthOf(surface.curves[1], 2), 1e-12);
  EXPECT_NEAR(result.curves[1].flatLength, lengthOf(surface.curves[1], 2), 1e-9);
  EXPECT_EQ(result.curves[2].restLength, 0.0);
  EXPECT_EQ(result.curves[2].flatLength, 0.0);
  for (const Wire& wire : result.wires)
  {
    EXPECT_NE(wire.curve, 2);
    EXPECT_EQ(wire.vertices.size(), wire.curve == 1 ? 3U : 9U);
  }
}

TEST(PieceTopology, TheCacheKnowsWhetherPiecesWereSkipped)
{
  for (const Surface& surface :
    { together({ shirt(), partOf(tetrahedron()), shirt() }), seamedTorus(), shirt() })
  {
    FlatteningCache cache;
    for (const bool skip : { false, true, true, false, true })
    {
      FlatteningOptions options = skipping();
      options.skipClosed = skip;
      const FlatteningResult kept = flatten(surface, options, {}, &cache);
      expectSame(kept, flatten(surface, options));
      EXPECT_EQ(kept.leftOut.size(), flatten(surface, options).leftOut.size());
    }
  }
}
