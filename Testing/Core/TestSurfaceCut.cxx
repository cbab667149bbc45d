// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/SurfaceCut.h"
#include "WiredSurface.h"

#include <map>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// How many boundary vertices of the cut surface are copies of an original vertex.
Index copiesOf(const CutSurface& cut, Index original)
{
  return static_cast<Index>(
    std::count(cut.originalVertex.begin(), cut.originalVertex.end(), original));
}

/// Both edges of each pair were one edge, run against each other and are open now.
void expectSewable(const TriangleMesh& mesh, const CutSurface& cut)
{
  for (const SeamPair& pair : cut.seamPairs)
  {
    EXPECT_EQ(mesh.twin(pair.first), pair.second);
    EXPECT_EQ(cut.mesh.twin(pair.first), none);
    EXPECT_EQ(cut.mesh.twin(pair.second), none);
    EXPECT_DOUBLE_EQ(cut.mesh.length(pair.first), cut.mesh.length(pair.second));
    EXPECT_EQ(
      cut.originalVertex[cut.mesh.from(pair.first)], cut.originalVertex[cut.mesh.to(pair.second)]);
    EXPECT_EQ(
      cut.originalVertex[cut.mesh.to(pair.first)], cut.originalVertex[cut.mesh.from(pair.second)]);
    EXPECT_EQ(cut.curveOfHalfedge[pair.first], pair.curve);
    EXPECT_EQ(cut.curveOfHalfedge[pair.second], pair.curve);
  }
}

void expectRefusal(const CutSurface& cut, StatusCode code, ElementKind kind, const Indices& ids)
{
  EXPECT_STREQ(statusName(cut.status.code), statusName(code));
  EXPECT_EQ(cut.status.ids, (ElementIds{ kind, ids }));
  EXPECT_NE(cut.status.message.find("\"c\""), std::string::npos) << cut.status.message;
}
}

TEST(SurfaceCut, OpensCutsButNotTheirTipsAndPartsThePieces)
{
  const auto v = [](Index i, Index j) { return at(6, i, j); };
  const auto dart = [](Indices vertices) { return curveOf(CurveType::Dart, "d", vertices); };
  struct Case
  {
    const char* name;
    std::vector<FeatureCurve> curves;
    std::map<Index, Index> copies; ///< of vertices
    std::size_t seamPairs;
    Index pieces;
    Index euler;
  };
  const std::vector<Case> cases{
    { "what cuts nothing", { rowCurve(6, 2), curveOf(CurveType::Key, "k", { v(2, 0), v(2, 1) }) },
      {}, 0, 1, 1 },
    { "a dart from the boundary", { dart({ v(3, 0), v(3, 1), v(3, 2) }) },
      { { v(3, 0), 2 }, { v(3, 1), 2 }, { v(3, 2), 1 } }, 2, 1, 1 },
    { "one inside, which leaves a hole", { dart({ v(3, 1), v(3, 2), v(3, 3), v(3, 4) }) },
      { { v(3, 1), 1 }, { v(3, 2), 2 }, { v(3, 4), 1 } }, 3, 1, 0 },
    { "one inner edge, which opens nothing", { dart({ v(3, 2), v(3, 3) }) },
      { { v(3, 2), 1 }, { v(3, 3), 1 } }, 0, 1, 1 },
    { "a dart from side to side", { dart(columnCurve(6, 6, 2).vertices) }, { { v(2, 3), 2 } }, 6, 2,
      2 },
    { "a seam from side to side", { columnCurve(6, 6, 2, CurveType::Seam) }, { { v(2, 3), 2 } }, 6,
      2, 2 },
    { "three darts to one vertex",
      { dart({ v(3, 0), v(3, 1), v(3, 2), v(3, 3) }), dart({ v(0, 3), v(1, 3), v(2, 3), v(3, 3) }),
        dart({ v(3, 3), v(4, 3), v(5, 3), v(6, 3) }) },
      { { v(3, 3), 3 } }, 9, 3, 3 },
  };
  const Surface surface = cushion(6, 6, 0.3);
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    const CutSurface cut = cutSurface(surface.mesh, one.curves);
    ASSERT_TRUE(cut.status.ok());
    for (const auto& [vertex, count] : one.copies)
    {
      EXPECT_EQ(copiesOf(cut, vertex), count);
    }
    EXPECT_EQ(cut.seamPairs.size(), one.seamPairs);
    expectSewable(surface.mesh, cut);
    EXPECT_EQ(cut.pieceCount, one.pieces);
    EXPECT_EQ(eulerCharacteristic(cut.mesh), one.euler);
    EXPECT_EQ(extractPieces(cut).front().triangles.front(), 0) << "in the order of their triangles";
  }
}

TEST(SurfaceCut, TwoDartsThatMeetInsideCutAsOne)
{
  const Surface surface = cushion(4, 4, 0.3);
  const CutSurface together =
    cutSurface(surface.mesh, { curveOf(CurveType::Dart, "d", { 2, 7, 12, 13 }) });
  const CutSurface parts = cutSurface(surface.mesh,
    { curveOf(CurveType::Dart, "a", { 2, 7, 12 }), curveOf(CurveType::Dart, "b", { 13, 12 }) });
  EXPECT_EQ(parts.mesh.triangles(), together.mesh.triangles());
  EXPECT_EQ(parts.originalVertex, together.originalVertex);
  EXPECT_EQ(copiesOf(parts, 12), 2);
}

TEST(SurfaceCut, ACurveThatEndsOnADartKeepsToItsSide)
{
  // A girth in two parts, one from each side to the dart.
  const Surface surface = cushion(4, 4, 0.3);
  const std::vector<FeatureCurve> curves{ curveOf(CurveType::Dart, "dart", { 2, 7, 12 }),
    accessory("left", { 5, 6, 7 }), accessory("right", { 7, 8, 9 }) };
  const CutSurface cut = cutSurface(surface.mesh, curves);
  // The copy of vertex 7 in the triangles next to each part.
  const Index left = cut.mesh.to(surface.mesh.find(6, 7));
  const Index right = cut.mesh.from(surface.mesh.find(7, 8));
  EXPECT_NE(left, right);
  EXPECT_NE(cut.mesh.find(cut.mesh.from(surface.mesh.find(6, 7)), left), none);
  for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
  {
    const Triangle& c = cut.mesh.triangle(t);
    const double x =
      (cut.mesh.point(c[0]).x() + cut.mesh.point(c[1]).x() + cut.mesh.point(c[2]).x()) / 3.0;
    EXPECT_TRUE(x < 0.5 || std::count(c.begin(), c.end(), left) == 0);
    EXPECT_TRUE(x > 0.5 || std::count(c.begin(), c.end(), right) == 0);
  }
}

TEST(SurfaceCut, OfCurvesOnOneEdgeTheCutGoesFirst)
{
  const Surface surface = cushion(4, 4, 0.3);
  const Indices chain{ 2, 7, 12 };
  const std::vector<FeatureCurve> curves{ curveOf(CurveType::Accessory, "a", chain),
    curveOf(CurveType::Key, "k", chain), curveOf(CurveType::Dart, "d", chain),
    curveOf(CurveType::Key, "second", { 12, 17 }), curveOf(CurveType::Key, "third", { 12, 17 }) };
  const CutSurface cut = cutSurface(surface.mesh, curves);
  EXPECT_EQ(cut.curveOfHalfedge[surface.mesh.find(2, 7)], 2);
  EXPECT_EQ(cut.curveOfHalfedge[surface.mesh.find(7, 2)], 2);
  EXPECT_EQ(cut.curveOfHalfedge[surface.mesh.find(12, 17)], 3);
}

TEST(SurfaceCut, PiecesPointBackToTheCutSurface)
{
  Surface surface = cushion(4, 4, 0.3);
  const CutSurface cut =
    cutSurface(surface.mesh, { columnCurve(4, 4, 1, CurveType::Seam), rowCurve(4, 2) });
  Index triangles = 0;
  for (const Piece& piece : extractPieces(cut))
  {
    triangles += piece.mesh.triangleCount();
    for (Index t = 0; t < piece.mesh.triangleCount(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_EQ(
          piece.vertices[piece.mesh.triangle(t)[k]], cut.mesh.triangle(piece.triangles[t])[k]);
        EXPECT_EQ(
          piece.curveOfHalfedge[3 * t + k], cut.curveOfHalfedge[3 * piece.triangles[t] + k]);
      }
    }
  }
  EXPECT_EQ(triangles, surface.mesh.triangleCount());
}

TEST(SurfaceCut, NamesCurvesThatAreNoChainsOfEdges)
{
  const TriangleMesh mesh = cushion(4, 4, 0.3).mesh;
  expectRefusal(cutSurface(mesh, { accessory("c", { 3 }) }), StatusCode::CurveTooShort,
    ElementKind::Points, { 3 });
  expectRefusal(
    cutSurface(mesh, { accessory("c", {}) }), StatusCode::CurveTooShort, ElementKind::Points, {});
  expectRefusal(cutSurface(mesh, { accessory("c", { 0, 1, 24 }) }), StatusCode::CurveNotOnEdges,
    ElementKind::Edges, { 1, 24 });
  expectRefusal(cutSurface(mesh, { accessory("c", { 0, 1, 1 }) }), StatusCode::CurveNotOnEdges,
    ElementKind::Edges, { 1, 1 });
  expectRefusal(cutSurface(mesh, { accessory("c", { 0, 25 }) }), StatusCode::InvalidPointId,
    ElementKind::Points, { 25 });
  expectRefusal(cutSurface(mesh, { accessory("c", { -1, 0 }) }), StatusCode::InvalidPointId,
    ElementKind::Points, { -1 });
}

TEST(CutEnds, AreNamedWithTheVertexThatContinuesThemToTheBoundary)
{
  const auto v = [](Index i, Index j) { return at(6, i, j); };
  const auto seam = [](Indices vertices) { return curveOf(CurveType::Seam, "s", vertices); };
  const auto dart = [](Indices vertices) { return curveOf(CurveType::Dart, "d", vertices); };
  struct Case
  {
    const char* name;
    std::vector<FeatureCurve> curves;
    std::vector<std::array<Index, 3>> ends; ///< curve, its vertex, and that of the boundary
  };
  const std::vector<Case> cases{
    { "a dart", { dart({ v(3, 1), v(3, 2), v(3, 3) }) }, { { 0, v(3, 1), v(3, 0) } } },
    { "a dart that was drawn from its tip",
      { accessory("a", { v(0, 3), v(1, 3) }), dart({ v(3, 3), v(4, 3), v(5, 3) }) },
      { { 1, v(5, 3), v(6, 3) } } },
    { "both ends of a seam", { seam({ v(3, 1), v(3, 2), v(3, 3), v(3, 4), v(3, 5) }) },
      { { 0, v(3, 1), v(3, 0) }, { 0, v(3, 5), v(3, 6) } } },
    { "the nearer end of a dart, whose other is its tip",
      { dart({ v(3, 1), v(3, 2), v(3, 3), v(3, 4), v(3, 5) }) }, { { 0, v(3, 5), v(3, 6) } } },
    { "the tip of a short dart", { dart({ v(3, 0), v(3, 1) }) }, {} },
    { "a dart from a seam", { seam({ v(3, 0), v(3, 1), v(3, 2) }), dart({ v(3, 1), v(2, 1) }) },
      {} },
    { "what cuts nothing", { curveOf(CurveType::Key, "k", { v(3, 1), v(3, 2), v(3, 3) }) }, {} },
    { "a dart far from the boundary", { dart({ v(3, 2), v(3, 3), v(3, 4) }) }, {} },
    { "a closed seam", { seam({ v(1, 1), v(2, 1), v(2, 2), v(1, 2), v(1, 1) }) }, {} },
  };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    const std::vector<ShortEnd> found = endsShortOfBoundary(flatPatch(6, 6).mesh, one.curves);
    ASSERT_EQ(found.size(), one.ends.size());
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      EXPECT_EQ((std::array{ found[k].curve, found[k].vertex, found[k].boundary }), one.ends[k]);
    }
  }
}
