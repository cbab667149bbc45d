// SPDX-License-Identifier: BSD-3-Clause
// Curves anywhere on a surface: holes, darts that meet, wires that end or float inside.
#include "ClosedMeshes.h"
#include "Flattened.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr Index gridSize = 8;

/// Vertex (i, j).
Index at(Index i, Index j)
{
  return testmeshes::at(gridSize, i, j);
}

FeatureCurve dart(Indices vertices)
{
  return curveOf(CurveType::Dart, "dart", std::move(vertices));
}

Indices ring()
{
  return { at(3, 3), at(4, 3), at(5, 3), at(5, 4), at(5, 5), at(4, 5), at(3, 5), at(3, 4),
    at(3, 3) };
}

/// Curve sets on a grid of 8 x 8, by name, and how many pieces they leave.
struct Case
{
  const char* name;
  std::vector<FeatureCurve> curves;
  std::size_t pieces;
};

std::vector<Case> cases()
{
  const FeatureCurve row = rowCurve(gridSize, 4);
  const FeatureCurve seam = columnCurve(gridSize, gridSize, 3, CurveType::Seam);
  FeatureCurve closedSeam = curveOf(CurveType::Seam, "ring", ring());
  return {
    { "fish-eye dart", { dart({ at(4, 2), at(4, 3), at(4, 4), at(4, 5) }) }, 1 },
    { "fish-eye dart under a girth",
      { dart({ at(4, 2), at(4, 3), at(4, 4), at(4, 5), at(4, 6) }), row }, 1 },
    { "two fish-eye darts",
      { dart({ at(2, 2), at(2, 3), at(2, 4) }), dart({ at(6, 4), at(6, 5), at(6, 6) }) }, 1 },
    { "darts that meet", { dart({ at(4, 0), at(4, 1), at(4, 2) }), dart({ at(4, 2), at(5, 2) }) },
      1 },
    { "fish-eye darts that cross",
      { dart({ at(4, 2), at(4, 3), at(4, 4), at(4, 5) }),
        dart({ at(2, 4), at(3, 4), at(4, 4), at(5, 4) }) },
      1 },
    { "three darts to one vertex cut through",
      { dart({ at(4, 0), at(4, 1), at(4, 2) }),
        dart({ at(8, 2), at(7, 2), at(6, 2), at(5, 2), at(4, 2) }),
        dart({ at(0, 2), at(1, 2), at(2, 2), at(3, 2), at(4, 2) }) },
      3 },
    { "a dart between two boundary points",
      { dart(columnCurve(gridSize, gridSize, 5).vertices), row }, 2 },
    { "a seam with a girth across", { seam, row }, 2 },
    { "a seam around a region", { closedSeam }, 2 },
    { "a closed accessory curve", { accessory("ring", ring()) }, 1 },
    { "a dangling wire", { accessory("d", { at(4, 0), at(4, 1), at(4, 2), at(5, 2) }) }, 1 },
    { "a floating wire", { accessory("f", { at(3, 3), at(4, 3), at(4, 4) }) }, 1 },
    { "two floating wires",
      { accessory("f", { at(2, 2), at(3, 2) }), accessory("g", { at(5, 5), at(5, 6) }) }, 1 },
    { "curves that end on a dart",
      { dart({ at(4, 0), at(4, 1), at(4, 2), at(4, 3) }),
        accessory("left", { at(0, 2), at(1, 2), at(2, 2), at(3, 2), at(4, 2) }),
        accessory("right", { at(4, 1), at(5, 1), at(6, 1), at(7, 1), at(8, 1) }) },
      1 },
    { "a girth across a dart",
      { dart({ at(4, 0), at(4, 1), at(4, 2), at(4, 3) }), rowCurve(gridSize, 2) }, 1 },
    { "a curve along a dart",
      { dart({ at(4, 0), at(4, 1), at(4, 2) }),
        accessory("along", { at(4, 1), at(4, 2), at(4, 3) }) },
      1 },
    { "a dart of one inner edge", { dart({ at(4, 4), at(4, 5) }) }, 1 },
  };
}

FlatteningResult flattenedBy(const Surface& surface, Scheme scheme)
{
  return flatten(surface, optionsOf(scheme, InteriorMethod::AsRigidAsPossible));
}
}

TEST(FlatteningTopology, WhateverTheCurvesFlatSurfacesStayAndWiresOfCurvedOnesMeet)
{
  for (const Case& curveSet : cases())
  {
    SCOPED_TRACE(curveSet.name);
    Surface surface = flatPatch(gridSize, gridSize);
    surface.curves = curveSet.curves;
    Surface curved = cushion(gridSize, gridSize, 0.2);
    curved.curves = curveSet.curves;
    for (const Scheme scheme : { Scheme::Global, Scheme::Progressive, Scheme::Isometric })
    {
      const FlatteningResult result = flattenedBy(surface, scheme);
      ASSERT_TRUE(result.status.ok()) << result.status.message;
      ASSERT_EQ(result.pieces.size(), curveSet.pieces);
      EXPECT_LT(worstPiece(surface, result), 1e-10);
      for (const PieceReport& piece : result.pieces)
      {
        EXPECT_LT(piece.objective, 1e-20);
      }
      const FlatteningResult bent = flattenedBy(curved, scheme);
      ASSERT_FALSE(bent.status.refused()) << bent.status.message;
      EXPECT_STRNE(statusName(bent.status.code), "NotConverged");
      EXPECT_LT(worstLength(bent), 1e-12);
    }
  }
}

TEST(FlatteningTopology, ASurfaceWithTwoBoundaryLoopsLiesFlatAroundItsHole)
{
  // A flat sheet with its middle left out.
  Surface surface = flatPatch(gridSize, gridSize);
  const Point3 middle = surface.mesh.point(at(4, 4));
  const PreparedSurface holed =
    partWhere(surface.mesh, [&middle](const Point3& p) { return (p - middle).norm() > 1.3; });
  Points2 unrolled;
  for (const Index v : holed.originalPoint)
  {
    unrolled.push_back(surface.unrolled[v]);
  }
  surface.mesh = holed.mesh;
  ASSERT_EQ(surface.mesh.boundaryLoops().size(), 2U);
  for (const Scheme scheme : { Scheme::Global, Scheme::Progressive })
  {
    const FlatteningResult result = flattenedBy(surface, scheme);
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    EXPECT_LT(rigidDistance(result.positions, unrolled), 1e-10);
  }
}

TEST(FlatteningTopology, SeamsCutAClosedSurfaceIntoFlatPieces)
{
  // A box of 2 x 2 x 2 squares a side would need 12 edges; six seams leave its faces in one cross.
  const TriangleMesh box = cube();
  // The four upright edges and three edges of the lid: a cross that lies flat without distortion.
  std::vector<FeatureCurve> seams;
  for (const auto& [a, b] : std::vector<std::pair<Index, Index>>{
         { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 }, { 4, 5 }, { 5, 6 }, { 6, 7 } })
  {
    seams.push_back(curveOf(CurveType::Seam, "seam", { a, b }));
  }
  const FlatteningResult result = flattenSurface(box, seams, {}, {});
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_EQ(result.pieces.size(), 1U);
  EXPECT_EQ(result.cut->seamPairs.size(), 7U);
  EXPECT_LT(result.pieces.front().objective, 1e-20);
  for (const TriangleQuality& triangle : result.triangles)
  {
    EXPECT_NEAR(triangle.areaRatio, 1.0, 1e-12);
    EXPECT_NEAR(triangle.aspectRatio, 1.0, 1e-12);
  }
}

namespace
{
/// Walks along random edges of the mesh; they cross, touch and retrace each other as chance has it.
std::vector<FeatureCurve> randomCurves(const TriangleMesh& mesh, unsigned seed, bool keys)
{
  std::mt19937 random(seed);
  std::vector<FeatureCurve> curves;
  const Index count = 1 + static_cast<Index>(random() % 6);
  for (Index c = 0; c < count; ++c)
  {
    auto type = static_cast<CurveType>(random() % 4);
    if (type == CurveType::Key && !keys)
    {
      type = CurveType::Accessory;
    }
    Indices chain{ static_cast<Index>(random() % mesh.vertexCount()) };
    const std::size_t steps = 1 + random() % 12;
    while (chain.size() <= steps)
    {
      Indices neighbours;
      for (Index h = 0; h < mesh.halfedgeCount(); ++h)
      {
        if (mesh.from(h) == chain.back())
        {
          neighbours.push_back(mesh.to(h));
        }
        else if (mesh.to(h) == chain.back() && mesh.twin(h) == none)
        {
          neighbours.push_back(mesh.from(h));
        }
      }
      chain.push_back(neighbours[random() % neighbours.size()]);
    }
    curves.push_back(curveOf(type, "c" + std::to_string(c), std::move(chain)));
  }
  return curves;
}

FlatteningOptions optionsOf(unsigned seed)
{
  FlatteningOptions options;
  options.scheme = seed % 2 == 0 ? Scheme::Global : Scheme::Progressive;
  options.angles.method = seed % 3 == 0 ? AngleMethod::Sequential : AngleMethod::Newton;
  options.arrange = false;
  return options;
}
}

TEST(RandomCurves, FlatSurfacesFlattenToThemselves)
{
  Surface surface = flatPatch(7, 6);
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    surface.curves = randomCurves(surface.mesh, seed, true);
    const FlatteningResult result = flatten(surface, optionsOf(seed));
    // Cuts in a flat sheet leave sides that touch; they are no overlap.
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    for (const PieceReport& piece : result.pieces)
    {
      EXPECT_LT(piece.objective, 1e-20);
    }
    EXPECT_LT(worstPiece(surface, result), 1e-9);
  }
}

TEST(RandomCurves, WiresOfACurvedSurfaceMeet)
{
  Surface surface = cushion(7, 6, 0.12);
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    surface.curves = randomCurves(surface.mesh, seed, false);
    FlatteningOptions options = optionsOf(seed);
    options.angles.method = AngleMethod::Newton;
    const FlatteningResult result = flatten(surface, options);
    ASSERT_FALSE(result.status.refused()) << result.status.message;
    for (const Point2& p : result.positions)
    {
      ASSERT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
    }
    EXPECT_LT(worstLength(result), 1e-10);
  }
}

namespace
{
/// Meridians from a pole through parallels, sagging by a height.
TriangleMesh dome(Index meridians, Index parallels, double height)
{
  return disk(parallels, meridians, [height](double r, double turn) {
    return Point3(r * std::cos(turn), r * std::sin(turn), height * std::cos(1.3 * r));
  });
}
void expectExactLengths(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const std::vector<Scheme>& chosen, const Execution& execution = {})
{
  for (const Scheme scheme : chosen)
  {
    const FlatteningResult result = flattenSurface(mesh, curves, withScheme(scheme), execution);
    EXPECT_TRUE(result.status.ok()) << mesh.triangleCount() << ": " << result.status.message;
    ASSERT_EQ(result.positions.size(), static_cast<std::size_t>(mesh.vertexCount()));
    EXPECT_LT(worstLength(result), 1e-9) << mesh.triangleCount();
  }
}
}

TEST(HighValence, DomesWithAPoleKeepTheirBoundarysLengthInEveryScheme)
{
  for (const auto& [meridians, parallels] :
    std::vector<std::pair<Index, Index>>{ { 13, 2 }, { 32, 6 }, { 100, 3 }, { 1000, 2 } })
  {
    expectExactLengths(dome(meridians, parallels, 0.4), {},
      { Scheme::Progressive, Scheme::Global, Scheme::Isometric });
  }
}

TEST(HighValence, ConesAndDomesOfTensOfThousandsOfTrianglesTakeLittleMemory)
{
  // All factors of a sound order take less; a dense front of the ring would take 7 GB.
  Execution execution;
  execution.factorMemory = 120'000'000;
  for (const auto& [meridians, parallels] :
    std::vector<std::pair<Index, Index>>{ { 30000, 1 }, { 5600, 5 } })
  {
    expectExactLengths(
      dome(meridians, parallels, 0.4), {}, { Scheme::Global, Scheme::Isometric }, execution);
  }
}

TEST(HighValence, WiresByTheThousandMeetInOneVertex)
{
  // Half of the spokes of a flat half disc whose hub is on the boundary, in any numbering.
  constexpr Index spokes = 6000;
  Points3 points{ { 0.0, 0.0, 0.0 } };
  std::vector<FeatureCurve> curves;
  for (Index k = 0; k <= spokes; ++k)
  {
    const double a = pi * k / spokes;
    points.emplace_back(std::cos(a), std::sin(a), 0.0);
    if (k % 2 == 1)
    {
      curves.push_back(accessory("spoke " + std::to_string(k), { 0, k + 1 }));
    }
  }
  Execution execution;
  execution.factorMemory = 50'000'000;
  for (Scheme scheme : { Scheme::Progressive, Scheme::Global, Scheme::Isometric })
  {
    const FlatteningResult result = flattenSurface(
      { points, ringTriangles(spokes, 1, spokes + 1) }, curves, withScheme(scheme), execution);
    EXPECT_TRUE(result.status.ok()) << result.status.message;
    ASSERT_FALSE(result.positions.empty());
    for (const Wire& wire : result.wires)
    {
      EXPECT_NEAR(wire.flatLength, wire.restLength, 1e-9 * wire.restLength);
    }
  }
}
