// SPDX-License-Identifier: BSD-3-Clause
#include "TestMeshes.h"

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
