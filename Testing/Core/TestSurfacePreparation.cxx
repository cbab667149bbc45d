// SPDX-License-Identifier: BSD-3-Clause
#include "Base/CompressedRows.h"
#include "Base/Types.h"
#include "ClosedMeshes.h"
#include "Surface/VertexFan.h"
#include "TestMeshes.h"

#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
void expectRefusal(const PreparedSurface& prepared, StatusCode code, const Indices& ids)
{
  EXPECT_STREQ(statusName(prepared.status.code), statusName(code)) << prepared.status.message;
  EXPECT_TRUE(prepared.status.refused());
  const bool ofPoints = code == StatusCode::NonFinitePoint || code == StatusCode::NonManifoldVertex;
  EXPECT_EQ(
    prepared.status.ids, (ElementIds{ ofPoints ? ElementKind::Points : ElementKind::Cells, ids }));
  EXPECT_FALSE(prepared.status.remedies.empty());
  EXPECT_FALSE(prepared.status.message.empty());
  EXPECT_EQ(prepared.mesh.triangleCount(), 0) << "a refused surface has no mesh";
}

const Points3 squarePoints{ Point3(0, 0, 0), Point3(1, 0, 0), Point3(1, 1, 0), Point3(0, 1, 0) };
const Triangles squareTriangles{ { 0, 1, 2 }, { 0, 2, 3 } };
}

TEST(SurfacePreparation, KeepsASoundMeshAsItIs)
{
  const TriangleMesh mesh = cushion(4, 3, 0.2).mesh;
  const PreparedSurface prepared = prepareSurface(mesh.points(), mesh.triangles());
  ASSERT_TRUE(prepared.status.ok()) << prepared.status.message;
  EXPECT_EQ(prepared.mesh.points(), mesh.points());
  EXPECT_EQ(prepared.mesh.triangles(), mesh.triangles());
  EXPECT_TRUE(prepared.reversedTriangles.empty());
}

TEST(SurfacePreparation, NamesTheTrianglesOrPointsThatAreWrong)
{
  struct Case
  {
    StatusCode code;
    Triangles triangles;
    Indices ids;
  };
  // Point 4 is between points 0 and 1; what touches the square at point 0 alone has points 5 and 6.
  Points3 points = squarePoints;
  points.insert(points.end(), { Point3(0.5, 0, 0), Point3(-1, 0, 0), Point3(-1, -1, 0) });
  for (const auto& [code, triangles, ids] : std::vector<Case>{ { StatusCode::EmptySurface, {}, {} },
         { StatusCode::InvalidPointId, { { 0, 1, 2 }, { 0, 2, 7 }, { -1, 2, 3 } }, { 1, 2 } },
         { StatusCode::DegenerateTriangle, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 4, 1 } }, { 2 } },
         { StatusCode::DegenerateTriangle, { { 0, 1, 2 }, { 0, 2, 2 } }, { 1 } },
         { StatusCode::NonManifoldEdge, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 2, 5 } }, { 0, 1, 2 } },
         // Twice the same, in either orientation: each edge has two, but what splits one cannot
         // tell it from the other.
         { StatusCode::NonManifoldEdge, { { 0, 1, 2 }, { 0, 2, 1 } }, { 1 } },
         { StatusCode::NonManifoldEdge, { { 0, 1, 2 }, { 0, 2, 3 }, { 1, 2, 0 } }, { 2 } },
         { StatusCode::NonManifoldVertex, { { 0, 1, 2 }, { 0, 5, 6 } }, { 0 } } })
  {
    const PreparedSurface prepared = prepareSurface(points, triangles);
    expectRefusal(prepared, code, ids);
    EXPECT_TRUE(
      ids.size() < 3 || prepared.status.message.find("points 0 and 2") != std::string::npos);
  }
}

TEST(SurfacePreparation, NamesPointsThatAreNoNumbers)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL })
  {
    Points3 points = squarePoints;
    points[2].y() = bad;
    expectRefusal(prepareSurface(points, squareTriangles), StatusCode::NonFinitePoint, { 2 });
  }
}

TEST(SurfacePreparation, LeavesOutPointsThatNoTriangleUsesWhateverTheyHold)
{
  Points3 points{ Point3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0) };
  points.insert(points.end(), squarePoints.begin(), squarePoints.end());
  points.emplace_back(7.0, 7.0, 7.0);
  const PreparedSurface prepared = prepareSurface(points, { { 1, 2, 3 }, { 1, 3, 4 } });
  ASSERT_TRUE(prepared.status.ok()) << prepared.status.message;
  EXPECT_EQ(prepared.mesh.vertexCount(), 4);
  EXPECT_EQ(prepared.originalPoint, (Indices{ 1, 2, 3, 4 }));
  EXPECT_EQ(prepared.vertexOfPoint, (Indices{ none, 0, 1, 2, 3, none }));
}

TEST(SurfacePreparation, JudgesTheShapeOfTrianglesNotTheirSizeUnlessTheirAreaHasNoSquare)
{
  for (const double scale : { 1e-300, 1e-61, 1e-59, 1e-9, 1e9, 1e60, 1.1e60, 1e300 })
  {
    Points3 points = squarePoints;
    for (Point3& p : points)
    {
      p *= scale;
    }
    if (scale < 1e-60 || scale > 1e60)
    {
      const bool small = scale < 1.0;
      expectRefusal(prepareSurface(points, squareTriangles),
        small ? StatusCode::DegenerateTriangle : StatusCode::NonFinitePoint,
        small ? Indices{ 0, 1 } : Indices{ 1, 2, 3 });
      continue;
    }
    EXPECT_TRUE(prepareSurface(points, squareTriangles).status.ok()) << scale;
    points.emplace_back(0.5 * scale, 1e-14 * scale, 0.0);
    expectRefusal(prepareSurface(points, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 4, 1 } }),
      StatusCode::DegenerateTriangle, { 2 });
  }
}

TEST(SurfacePreparation, TurnsTheMinorityOfTrianglesOver)
{
  const TriangleMesh mesh = cushion(4, 4, 0.3).mesh;
  Triangles triangles = mesh.triangles();
  for (const Index t : { 3, 10, 11, 30 })
  {
    std::swap(triangles[t][0], triangles[t][1]);
  }
  const PreparedSurface prepared = prepareSurface(mesh.points(), triangles);
  ASSERT_TRUE(prepared.status.ok()) << prepared.status.message;
  EXPECT_EQ(prepared.reversedTriangles, (Indices{ 3, 10, 11, 30 }));
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& a = mesh.triangle(t);
    const Triangle& b = prepared.mesh.triangle(t);
    const Point3 n = areaVector(mesh.point(a[0]), mesh.point(a[1]), mesh.point(a[2]));
    EXPECT_GT(n.dot(areaVector(mesh.point(b[0]), mesh.point(b[1]), mesh.point(b[2]))), 0.0);
  }
}

TEST(SurfacePreparation, RefusesAMoebiusBand)
{
  // Three quads with a half twist.
  const Points3 points{ Point3(1, 0, -1), Point3(1, 0, 1), Point3(-1, 2, -1), Point3(-1, 2, 1),
    Point3(-1, -2, -1), Point3(-1, -2, 1) };
  const Triangles triangles{ { 0, 2, 1 }, { 1, 2, 3 }, { 2, 4, 3 }, { 3, 4, 5 }, { 4, 1, 5 },
    { 5, 1, 0 } };
  const PreparedSurface prepared = prepareSurface(points, triangles);
  EXPECT_STREQ(statusName(prepared.status.code), "NotOrientable");
  ASSERT_EQ(prepared.status.ids.values.size(), 2U);
  // The two triangles named are neighbours.
  const Triangle& a = triangles[prepared.status.ids.values[0]];
  const Triangle& b = triangles[prepared.status.ids.values[1]];
  EXPECT_EQ(std::count_if(a.begin(), a.end(),
              [&b](Index v) { return std::find(b.begin(), b.end(), v) != b.end(); }),
    2);
}

TEST(SurfacePreparation, JoinsATriangleSoup)
{
  const TriangleMesh mesh = cushion(3, 3, 0.3).mesh;
  Points3 points;
  Triangles triangles;
  for (const Triangle& t : mesh.triangles())
  {
    const auto first = static_cast<Index>(points.size());
    for (const Index v : t)
    {
      points.push_back(mesh.point(v));
    }
    triangles.push_back({ first, first + 1, first + 2 });
  }
  const PreparedSurface prepared = prepareSurface(points, triangles);
  ASSERT_TRUE(prepared.status.ok()) << prepared.status.message;
  EXPECT_EQ(prepared.mesh.vertexCount(), mesh.vertexCount());
  EXPECT_EQ(eulerCharacteristic(prepared.mesh), 1);
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    EXPECT_EQ(prepared.mesh.point(prepared.vertexOfPoint[p]), points[p]);
  }
}

TEST(SurfacePreparation, KeepsSidesThatMeetInSpaceApart)
{
  // A dart that is open in the mesh and closed in space.
  Surface surface = cushion(4, 4, 0.3);
  const TriangleMesh open =
    cutSurface(surface.mesh, { curveOf(CurveType::Dart, "dart", { 2, 7, 12 }) }).mesh;
  const PreparedSurface kept = prepareSurface(open.points(), open.triangles());
  ASSERT_TRUE(kept.status.ok()) << kept.status.message;
  EXPECT_EQ(kept.mesh.vertexCount(), surface.mesh.vertexCount() + 2);
  const PreparedSurface joined =
    prepareSurface(open.points(), open.triangles(), CoincidentPoints::Join);
  ASSERT_TRUE(joined.status.ok()) << joined.status.message;
  EXPECT_EQ(joined.mesh.vertexCount(), surface.mesh.vertexCount());
}

TEST(TriangleMesh, BoundaryLoopsAreClosedChainsWithTheLongestFirst)
{
  const TriangleMesh mesh = revolved(9, 1, 0.0, [](double share) { return 1.0 + share; });
  const std::vector<Indices> loops = mesh.boundaryLoops();
  ASSERT_EQ(loops.size(), 2U);
  for (const Indices& loop : loops)
  {
    ASSERT_EQ(loop.size(), 9U);
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      EXPECT_EQ(mesh.twin(loop[k]), none);
      EXPECT_EQ(mesh.to(loop[k]), mesh.from(loop[(k + 1) % loop.size()]));
    }
  }
  EXPECT_GE(mesh.from(loops.front().front()), 9) << "the outer circle has the later vertices";
  EXPECT_EQ(eulerCharacteristic(mesh), 0);
}

TEST(TriangleMesh, EulerCharacteristicCountsOnlyVerticesThatTrianglesUse)
{
  const TriangleMesh tetrahedron(
    { Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(0, 0, 1), Point3(9, 9, 9) },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  EXPECT_EQ(eulerCharacteristic(tetrahedron), 2);
  EXPECT_TRUE(tetrahedron.boundaryLoops().empty());
  EXPECT_FALSE(tetrahedron.onBoundary(0));
  EXPECT_EQ(tetrahedron.outgoing(4), none);
}

TEST(TriangleMesh, AFanHoldsEachHalfEdgeThatLeavesAVertexOnceWhereverItLies)
{
  const TriangleMesh mesh = flatPatch(4, 3).mesh;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    std::set<Index> expected;
    for (Index h = 0; h < mesh.halfedgeCount(); ++h)
    {
      if (mesh.from(h) == v)
      {
        expected.insert(h);
      }
    }
    Indices found;
    for (Index h : VertexFan(mesh, v))
    {
      found.push_back(h);
    }
    EXPECT_EQ(std::set<Index>(found.begin(), found.end()), expected) << v;
    EXPECT_EQ(found.size(), expected.size()) << v;
    // Counter-clockwise: the triangle of one half-edge leads to the next, to the left of the first.
    for (std::size_t k = 0; k + 1 < found.size(); ++k)
    {
      EXPECT_EQ(mesh.to(found[k + 1]), mesh.from(TriangleMesh::previous(found[k]))) << v;
    }
    if (!mesh.onBoundary(v))
    {
      Indices shifted;
      for (Index h : VertexFan::startingAt(mesh, found[1]))
      {
        shifted.push_back(h);
      }
      std::rotate(found.begin(), found.begin() + 1, found.end());
      EXPECT_EQ(shifted, found) << v;
    }
  }
}
