// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnCurves.h"
#include "Editing/CurveDrawing.h"
#include "PathFacts.h"
#include "Paths/GeodesicStraightening.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

using namespace flattening;
using namespace testmeshes;
using namespace drawncurves;

namespace
{
/// Surfaces that make it hard: equally long ways, bumps that no straight line sees, two parts.
std::vector<TriangleMesh> hardSurfaces(double scale = 1.0)
{
  const auto scaled = [scale](const TriangleMesh& mesh) {
    return moved(mesh, [scale](const Point3& p) -> Point3 { return scale * p; });
  };
  const TriangleMesh bumps = patch(40, 40, [](double i, double j) {
    return Point3(i, j, 5.0 * std::sin(0.9 * i) * std::sin(0.7 * j));
  }).mesh;
  Points3 points = bumps.points();
  Triangles triangles = bumps.triangles();
  for (const Point3& point : bumps.points())
  {
    points.push_back(point + Point3(0.0, 0.0, 1e9));
  }
  for (const Triangle& t : bumps.triangles())
  {
    const Index shift = bumps.vertexCount();
    triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  points.emplace_back(0.0, 0.0, -7.0); // of no triangle
  return { scaled(flatPatch(30, 30).mesh), scaled(cylinder(40, 20).mesh), scaled(bumps),
    scaled(TriangleMesh(points, triangles)) };
}

void expectSame(const GeodesicPath& a, const GeodesicPath& b)
{
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t k = 0; k < a.vertices.size(); ++k)
  {
    EXPECT_TRUE(samePlace(a.vertices[k], b.vertices[k]));
  }
  for (std::size_t k = 0; k < a.segments.size(); ++k)
  {
    EXPECT_EQ(a.segments[k].crossed, b.segments[k].crossed);
  }
}

void expectSame(const SurfacePath& a, const SurfacePath& b)
{
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.triangles, b.triangles);
  for (std::size_t k = 0; k < a.points.size(); ++k)
  {
    EXPECT_EQ(a.points[k].position, b.points[k].position);
  }
}
}

TEST(PathSearch, ThatGoesOnFindsTheWaysOfOneThatIsNew)
{
  for (const TriangleMesh& mesh : hardSurfaces())
  {
    const PathGraph graph(mesh);
    std::mt19937 random(11);
    for (const PathArcs arcs : { PathArcs::All, PathArcs::Edges })
    {
      for (int source = 0; source < 6; ++source)
      {
        const SurfacePoint from = randomPoint(mesh, random);
        PathSearch kept(graph, from, arcs);
        for (int k = 0; k < 40; ++k)
        {
          const SurfacePoint to = randomPoint(mesh, random);
          expectSame(kept.geodesicTo(to), PathSearch(graph, from, arcs).geodesicTo(to));
        }
      }
    }
  }
}

TEST(PathSearch, ByEdgesIsAsLongAsAnotherFindsThem)
{
  for (const TriangleMesh& mesh : hardSurfaces())
  {
    const PathGraph graph(mesh);
    std::mt19937 random(12);
    const SurfacePoint from = randomPoint(mesh, random);
    PathSearch search(graph, from, PathArcs::Edges);
    for (int k = 0; k < 40; ++k)
    {
      const SurfacePoint to = randomPoint(mesh, random);
      const double length = lengthByEdges(mesh, from, to);
      const StraightPath path = pathByEdges(search, to);
      EXPECT_EQ(std::isfinite(length), path.status.ok());
      if (path.status.ok() && commonTriangle(mesh, from, to) == none)
      {
        EXPECT_NEAR(path.length, length, 1e-12 * length);
      }
    }
  }
}

TEST(PathSearch, TakesTheSameOfEquallyLongWaysInEveryUnit)
{
  const auto idsOfWay = [](const TriangleMesh& mesh, const PathGraph& graph, int seed) {
    std::mt19937 random(seed);
    const SurfacePoint from = randomPoint(mesh, random);
    const SurfacePoint to = randomPoint(mesh, random);
    Indices ids;
    for (const SurfacePoint& vertex : PathSearch(graph, from).geodesicTo(to).vertices)
    {
      ids.push_back(vertex.id);
    }
    return ids;
  };
  const std::vector<TriangleMesh> meshes = hardSurfaces();
  for (const double scale : { 1e-3, 0.3048, 1e3 })
  {
    const std::vector<TriangleMesh> scaled = hardSurfaces(scale);
    for (std::size_t m = 0; m < meshes.size(); ++m)
    {
      const PathGraph graph(meshes[m]);
      const PathGraph other(scaled[m]);
      for (int k = 0; k < 100; ++k)
      {
        EXPECT_EQ(idsOfWay(meshes[m], graph, k), idsOfWay(scaled[m], other, k)) << k;
      }
    }
  }
}

TEST(SegmentPreview, IsWhatIsDrawnThereWhateverWasShownBefore)
{
  const auto surface = std::make_shared<const DrawingSurface>(hill().mesh);
  const DrawingSurface plain(hill().mesh);
  SegmentPreview preview(surface);
  std::mt19937 random(4);
  SurfacePoint from = randomPoint(plain.mesh(), random);
  for (int k = 0; k < 200; ++k)
  {
    if (k % 7 == 0)
    {
      from = randomPoint(plain.mesh(), random);
    }
    const SurfacePoint to = randomPoint(plain.mesh(), random);
    const auto kind = static_cast<SegmentKind>(random() % 4);
    const DrawnSegment shown = preview.draw(kind, from, to);
    const DrawnSegment drawn = drawSegment(plain, kind, from, to);
    ASSERT_EQ(shown.status.code, drawn.status.code);
    expectSame(shown.path, drawn.path);
  }
}

TEST(SegmentPreview, RefusesWhatIsNoPointOfTheSurface)
{
  SegmentPreview preview(drawing(hill()));
  const SurfacePoint there = drawing(hill())->pointNear(Point3(3.0, 4.0, 0.0));
  const SurfacePoint nowhere{ SurfacePointType::Vertex, 1000000, { 1.0, 0.0, 0.0 },
    Point3::Zero() };
  for (const SegmentKind kind : { SegmentKind::Geodesic, SegmentKind::Edges, SegmentKind::Spline })
  {
    EXPECT_EQ(preview.draw(kind, there, nowhere).status.code, StatusCode::InvalidPointId);
    EXPECT_EQ(preview.draw(kind, nowhere, there).status.code, StatusCode::InvalidPointId);
    EXPECT_TRUE(preview.draw(kind, there, there).status.ok());
  }
}
