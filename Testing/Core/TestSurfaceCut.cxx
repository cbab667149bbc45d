// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedMeshes.h"
#include "Cut/SurfaceCut.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Vertex (i, j) of a patch with n columns.
Index at(Index n, Index i, Index j)
{
  return j * (n + 1) + i;
}

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

TEST(SurfaceCut, LeavesASurfaceWithoutDartsAndSeamsWhole)
{
  const Surface surface = cushion(4, 4, 0.3);
  const CutSurface cut =
    cutSurface(surface.mesh, { rowCurve(4, 2), curveOf(CurveType::Key, "k", { 2, 7, 12 }) });
  ASSERT_TRUE(cut.status.ok());
  EXPECT_EQ(cut.mesh.triangles(), surface.mesh.triangles());
  EXPECT_TRUE(cut.seamPairs.empty());
  EXPECT_EQ(cut.pieceCount, 1);
}

TEST(SurfaceCut, OpensADartFromTheBoundaryButNotItsTip)
{
  const Surface surface = cushion(4, 4, 0.3);
  const CutSurface cut = cutSurface(surface.mesh, { curveOf(CurveType::Dart, "d", { 2, 7, 12 }) });
  ASSERT_TRUE(cut.status.ok());
  EXPECT_EQ(copiesOf(cut, 2), 2);
  EXPECT_EQ(copiesOf(cut, 7), 2);
  EXPECT_EQ(copiesOf(cut, 12), 1);
  EXPECT_EQ(cut.seamPairs.size(), 2U);
  expectSewable(surface.mesh, cut);
  EXPECT_EQ(cut.pieceCount, 1);
  EXPECT_EQ(cut.mesh.boundaryLoops().size(), 1U);
  EXPECT_EQ(eulerCharacteristic(cut.mesh), 1);
}

TEST(SurfaceCut, OpensAFishEyeDartIntoAHole)
{
  const Surface surface = cushion(6, 6, 0.3);
  const CutSurface cut = cutSurface(surface.mesh,
    { curveOf(CurveType::Dart, "eye", { at(6, 3, 1), at(6, 3, 2), at(6, 3, 3), at(6, 3, 4) }) });
  EXPECT_EQ(copiesOf(cut, at(6, 3, 1)), 1);
  EXPECT_EQ(copiesOf(cut, at(6, 3, 2)), 2);
  EXPECT_EQ(copiesOf(cut, at(6, 3, 4)), 1);
  EXPECT_EQ(cut.mesh.boundaryLoops().size(), 2U);
  EXPECT_EQ(eulerCharacteristic(cut.mesh), 0);
  expectSewable(surface.mesh, cut);
}

TEST(SurfaceCut, ACutOfOneInnerEdgeOpensNothing)
{
  const Surface surface = cushion(4, 4, 0.3);
  const CutSurface cut =
    cutSurface(surface.mesh, { curveOf(CurveType::Dart, "d", { at(4, 2, 1), at(4, 2, 2) }) });
  ASSERT_TRUE(cut.status.ok());
  EXPECT_EQ(cut.mesh.triangles(), surface.mesh.triangles());
  EXPECT_TRUE(cut.seamPairs.empty());
}

TEST(SurfaceCut, ADartBetweenTwoBoundaryPointsSeparates)
{
  const Surface surface = cushion(4, 4, 0.3);
  FeatureCurve dart = columnCurve(4, 4, 2);
  for (const CurveType type : { CurveType::Dart, CurveType::Seam })
  {
    dart.type = type;
    const CutSurface cut = cutSurface(surface.mesh, { dart });
    EXPECT_EQ(cut.pieceCount, 2);
    EXPECT_EQ(cut.seamPairs.size(), 4U);
    expectSewable(surface.mesh, cut);
    const std::vector<Piece> pieces = extractPieces(cut);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].mesh.vertexCount() + pieces[1].mesh.vertexCount(), 25 + 5);
    EXPECT_EQ(pieces[0].triangles.front(), 0) << "pieces are in the order of their triangles";
  }
}

TEST(SurfaceCut, SeveralDartsAtOneVertexGiveItACopyEach)
{
  const Surface surface = cushion(4, 4, 0.3);
  const Index center = at(4, 2, 2);
  const auto dart = [](Indices v) { return curveOf(CurveType::Dart, "d", std::move(v)); };
  const std::vector<FeatureCurve> three{ dart({ 2, 7, center }), dart({ 10, 11, center }),
    dart({ center, 13, 14 }) };
  const CutSurface cut = cutSurface(surface.mesh, three);
  EXPECT_EQ(copiesOf(cut, center), 3);
  EXPECT_EQ(cut.pieceCount, 3);
  EXPECT_EQ(cut.seamPairs.size(), 6U);
  expectSewable(surface.mesh, cut);
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
  std::set<Index> leftTriangles;
  std::set<Index> rightTriangles;
  for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
  {
    for (const Index v : cut.mesh.triangle(t))
    {
      const double x = (surface.mesh.point(surface.mesh.triangle(t)[0]).x() +
                         surface.mesh.point(surface.mesh.triangle(t)[1]).x() +
                         surface.mesh.point(surface.mesh.triangle(t)[2]).x()) /
        3.0;
      if (v == left)
      {
        EXPECT_LT(x, 0.5);
      }
      if (v == right)
      {
        EXPECT_GT(x, 0.5);
      }
    }
  }
}

TEST(SurfaceCut, SeamsCutAClosedSurfaceIntoPieces)
{
  const TriangleMesh octahedron = sphere(0);
  const CutSurface cut =
    cutSurface(octahedron, { curveOf(CurveType::Seam, "equator", { 0, 2, 1, 3, 0 }) });
  EXPECT_EQ(cut.pieceCount, 2);
  EXPECT_EQ(cut.seamPairs.size(), 4U);
  expectSewable(octahedron, cut);
  for (const Piece& piece : extractPieces(cut))
  {
    EXPECT_EQ(eulerCharacteristic(piece.mesh), 1);
    EXPECT_EQ(piece.mesh.vertexCount(), 5);
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
