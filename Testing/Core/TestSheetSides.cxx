// SPDX-License-Identifier: BSD-3-Clause
#include "TestMeshes.h"

#include "Surface/SheetSides.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// The sides of a sheet at two distances along its normals, with or without a rim between them.
/// The first triangles are of the upper side.
TriangleMesh thickened(
  const TriangleMesh& sheet, double up, double down, bool rim, bool turned = false)
{
  Points3 points;
  const Index count = sheet.vertexCount();
  std::vector<Point3> normals(count, Point3::Zero());
  for (const Triangle& t : sheet.triangles())
  {
    for (Index v : t)
    {
      normals[v] += areaVector(sheet.point(t[0]), sheet.point(t[1]), sheet.point(t[2]));
    }
  }
  for (const double distance : { up, -down })
  {
    for (Index v = 0; v < count; ++v)
    {
      const bool sewn = !rim && sheet.onBoundary(v);
      points.push_back(sheet.point(v) + (sewn ? 0.0 : distance) * normals[v].normalized());
    }
  }
  const auto lower = [&](Index v) { return !rim && sheet.onBoundary(v) ? v : v + count; };
  Triangles cells = sheet.triangles();
  for (const auto& [a, b, c] : sheet.triangles())
  {
    cells.push_back({ lower(c), lower(b), lower(a) });
  }
  for (Index h = 0; rim && h < sheet.halfedgeCount(); ++h)
  {
    if (sheet.twin(h) == none)
    {
      const Index a = sheet.from(h);
      const Index b = sheet.to(h);
      cells.push_back({ b, a, lower(a) });
      cells.push_back({ b, lower(a), lower(b) });
    }
  }
  for (Triangle& cell : cells)
  {
    std::swap(cell[0], cell[turned ? 1 : 0]);
  }
  return TriangleMesh(std::move(points), std::move(cells));
}

void expectClear(const TriangleMesh& body, Index outer, double thickness)
{
  const std::vector<ThickSheet> sheets = thickSheets(body);
  ASSERT_EQ(sheets.size(), 1U);
  EXPECT_TRUE(sheets[0].isClear);
  EXPECT_EQ(static_cast<Index>(sheets[0].outer.size()), outer);
  EXPECT_EQ(static_cast<Index>(sheets[0].triangles.size()), body.triangleCount());
  EXPECT_NEAR(sheets[0].thickness, thickness, 0.1 * thickness);
}

TriangleMesh bowl()
{
  return sphereCap(1.8, 24, 0).mesh;
}

/// A channel of three walls at right angles.
TriangleMesh channel()
{
  return patch(24, 16, [](double i, double j) {
    const double across = std::clamp(i, 8.0, 16.0);
    return Point3(across, j, std::abs(i - across));
  }).mesh;
}
}

TEST(SheetSides, OfABowlTheOuterSideIsTaken)
{
  const TriangleMesh sheet = bowl();
  for (bool turned : { false, true })
  {
    const TriangleMesh body = thickened(sheet, 0.02, 0.02, true, turned);
    expectClear(body, sheet.triangleCount(), 0.04);
    const std::vector<ThickSheet> sheets = thickSheets(body);
    for (Index t : sheets.at(0).outer)
    {
      EXPECT_LT(t, sheet.triangleCount()); // those made first are outside
    }
  }
}

TEST(SheetSides, FoldsOfASheetDoNotEndItsSide)
{
  const TriangleMesh sheet = channel();
  expectClear(thickened(sheet, 0.1, 0.1, true), sheet.triangleCount(), 0.2);
}

TEST(SheetSides, ThinBodiesThatAreNoClothKeepBothSides)
{
  const TriangleMesh flat = unitSquares(20, 12).mesh;
  for (const TriangleMesh& body :
    { thickened(flat, 0.2, 0.2, true), thickened(flat, 0.2, 0.2, false),
      thickened(bowl(), 0.02, 0.02, false), thickened(bowl(), 0.2, 0.2, true), torus(24, 12.0) })
  {
    for (const ThickSheet& sheet : thickSheets(body))
    {
      EXPECT_FALSE(sheet.isClear);
    }
  }
}

TEST(SheetSides, AreFoundInOneOfManyPartsAndInTheSmallestUnit)
{
  const TriangleMesh sheet = bowl();
  const TriangleMesh thick = moved(
    thickened(sheet, 0.02, 0.02, true), [](const Point3& point) { return Point3(1e-6 * point); });
  const auto alone = [](const TriangleMesh& mesh) { return Surface{ mesh, {}, {} }; };
  const Surface both = together({ alone(torus(24, 3.0)), alone(thick), alone(sheet) });
  const std::vector<ThickSheet> sheets = thickSheets(both.mesh);
  ASSERT_EQ(sheets.size(), 1U);
  EXPECT_TRUE(sheets[0].isClear);
  EXPECT_EQ(sheets[0].outer.front(), torus(24, 3.0).triangleCount());
  EXPECT_EQ(static_cast<Index>(sheets[0].outer.size()), sheet.triangleCount());
}
