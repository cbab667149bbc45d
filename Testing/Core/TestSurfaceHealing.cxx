// SPDX-License-Identifier: BSD-3-Clause
#include "Input/InputSurface.h"
#include "Surface/SurfaceHealing.h"
#include "TestMeshes.h"

#include <numeric>
#include <random>
#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr Index sheetColumns = 12;
constexpr Index sheetRows = 10;

/// A sheet to be damaged.
struct Sheet
{
  Points3 points;
  Triangles triangles;

  Sheet()
  {
    const TriangleMesh mesh = cushion(sheetColumns, sheetRows, 0.2).mesh;
    this->points = mesh.points();
    this->triangles = mesh.triangles();
  }
  static Index at(Index i, Index j) { return j * (sheetColumns + 1) + i; }
  Index add(const Point3& p)
  {
    this->points.push_back(p);
    return static_cast<Index>(this->points.size()) - 1;
  }
  Index size() const { return static_cast<Index>(this->triangles.size()); }
  /// The triangles with all of some corners.
  Indices with(const Indices& corners) const
  {
    Indices found;
    for (Index t = 0; t < this->size(); ++t)
    {
      const Triangle& c = this->triangles[t];
      if (std::all_of(corners.begin(), corners.end(),
            [&c](Index p) { return std::find(c.begin(), c.end(), p) != c.end(); }))
      {
        found.push_back(t);
      }
    }
    return found;
  }
};

/// The healed surface, with this one kind of defect, named by these ids.
HealedSurface healed(const Sheet& sheet, SurfaceDefect defect, const std::vector<std::int64_t>& ids)
{
  HealedSurface surface = healSurface(sheet.points, sheet.triangles);
  EXPECT_TRUE(surface.status.ok()) << surface.status.message;
  for (const Mending& mending : surface.mendings)
  {
    if (mending.defect == defect)
    {
      EXPECT_EQ(mending.ids.values, ids) << describe(mending);
      return surface;
    }
  }
  ADD_FAILURE() << "the defect is not named";
  return surface;
}

std::vector<SurfaceDefect> defectsOf(const HealedSurface& surface)
{
  std::vector<SurfaceDefect> defects;
  for (const Mending& mending : surface.mendings)
  {
    defects.push_back(mending.defect);
  }
  return defects;
}

using DefectMix = std::vector<SurfaceDefect>;
}

TEST(SurfaceHealing, LeavesASoundSurfaceAsItIs)
{
  const Sheet sheet;
  const PreparedSurface prepared = prepareSurface(sheet.points, sheet.triangles);
  const HealedSurface surface = healSurface(sheet.points, sheet.triangles);
  EXPECT_TRUE(surface.mesh.identical(prepared.mesh));
  EXPECT_EQ(surface.vertexOfPoint, prepared.vertexOfPoint);
  EXPECT_TRUE(surface.mendings.empty());
  EXPECT_TRUE(surface.originalTriangle.empty());
}

TEST(SurfaceHealing, JoinsCollapsedPointsWithTheirNeighbors)
{
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    for (const double part : { 0.0, 5e-7 })
    {
      Sheet sheet;
      const Index moved = Sheet::at(5, 5);
      const Index neighbor = Sheet::at(4, 5);
      sheet.points[moved] = sheet.points[neighbor] + Point3(part / sheetColumns, 0.0, 0.0);
      const Indices between = sheet.with({ moved, neighbor });
      for (Point3& p : sheet.points)
      {
        p *= scale;
      }
      const HealedSurface surface = healed(sheet, SurfaceDefect::CollapsedPoints, { moved });
      EXPECT_EQ(defectsOf(surface),
        (DefectMix{ SurfaceDefect::CollapsedPoints, SurfaceDefect::FlatTriangles }));
      EXPECT_EQ(surface.mendings[1].ids, (ElementIds{ ElementKind::Cells, between }));
      EXPECT_EQ(surface.joinedPoints, Indices{ moved });
      EXPECT_EQ(surface.vertexOfPoint[moved], surface.vertexOfPoint[neighbor]);
      EXPECT_EQ(surface.originalPoint[surface.vertexOfPoint[neighbor]], neighbor);
      EXPECT_EQ(surface.mesh.triangleCount(), sheet.size() - 2);
      EXPECT_EQ(eulerCharacteristic(surface.mesh), 1);
    }
  }
  // An edge of three millionths is one.
  Sheet sheet;
  sheet.points[Sheet::at(5, 5)] =
    sheet.points[Sheet::at(4, 5)] + 3e-6 / sheetColumns * Point3::UnitX();
  EXPECT_TRUE(healSurface(sheet.points, sheet.triangles).mendings.empty());
}

TEST(SurfaceHealing, DividesWhatLiesBehindTrianglesWithoutArea)
{
  Sheet sheet;
  const double area = prepareSurface(sheet.points, sheet.triangles).mesh.area();
  // Two points on a diagonal, which the triangle on one side has and the other has not.
  const Index a = Sheet::at(4, 4);
  const Index c = Sheet::at(5, 5);
  const Index t = sheet.with({ a, c }).front();
  const Triangle whole = sheet.triangles[t];
  const Index b = whole[0] + whole[1] + whole[2] - a - c;
  const Index half = sheet.add(0.5 * (sheet.points[a] + sheet.points[c]));
  const Index quarter = sheet.add(0.5 * (sheet.points[a] + sheet.points[half]));
  const auto part = [&](Index from, Index to) {
    Triangle result = whole;
    std::replace(result.begin(), result.end(), from, to);
    return result;
  };
  Triangle middle = part(a, quarter);
  std::replace(middle.begin(), middle.end(), c, half);
  sheet.triangles[t] = part(c, quarter);
  sheet.triangles.push_back(middle);
  sheet.triangles.push_back(part(a, half));
  const Index first = sheet.size();
  sheet.triangles.push_back({ a, quarter, half });
  sheet.triangles.push_back({ a, half, c });
  sheet.triangles.push_back({ b, b, a });
  const HealedSurface surface =
    healed(sheet, SurfaceDefect::FlatTriangles, { first, first + 1, first + 2 });
  EXPECT_EQ(surface.mendings.size(), 1U);
  EXPECT_NEAR(surface.mesh.area() / area, 1.0, 1e-12);
  EXPECT_EQ(surface.mesh.triangleCount(), 2 * sheetColumns * sheetRows + 4);
  EXPECT_EQ(surface.mesh.boundaryLoops().size(), 1U);
  EXPECT_EQ(eulerCharacteristic(surface.mesh), 1);
}

TEST(SurfaceHealing, TakesOutDoubledTriangles)
{
  Sheet sheet;
  const Triangle t = sheet.triangles[40];
  const Triangle u = sheet.triangles[71];
  sheet.triangles.push_back({ t[1], t[2], t[0] });
  sheet.triangles.push_back({ u[0], u[2], u[1] });
  sheet.triangles.push_back(u);
  const Index count = 2 * sheetColumns * sheetRows;
  const HealedSurface surface =
    healed(sheet, SurfaceDefect::DoubledTriangles, { count, count + 1, count + 2 });
  EXPECT_EQ(surface.mendings.size(), 1U);
  EXPECT_EQ(surface.mesh.triangles(), Sheet().triangles);
  // A sheet with both of its sides is a sheet.
  Sheet sides;
  for (Index k = 0; k < count; ++k)
  {
    const Triangle s = sides.triangles[k];
    sides.triangles.push_back({ s[1], s[0], s[2] });
  }
  EXPECT_TRUE(healSurface(sides.points, sides.triangles)
                .mesh.identical(prepareSurface(Sheet().points, Sheet().triangles).mesh));
}

TEST(SurfaceHealing, SeparatesWhatStandsOnASurface)
{
  // A wall across the whole sheet: it comes off, since the sheet goes on evenly.
  Sheet sheet;
  Index before = none;
  for (Index j = 0; j <= sheetRows; ++j)
  {
    const Index foot = Sheet::at(6, j);
    const Index top = sheet.add(sheet.points[foot] + Point3(0.02, 0.0, 0.4));
    if (j > 0)
    {
      sheet.triangles.push_back({ Sheet::at(6, j - 1), foot, top });
      sheet.triangles.push_back({ Sheet::at(6, j - 1), top, before });
    }
    before = top;
  }
  const HealedSurface surface = healSurface(sheet.points, sheet.triangles);
  ASSERT_TRUE(surface.status.ok()) << surface.status.message;
  EXPECT_EQ(defectsOf(surface), DefectMix{ SurfaceDefect::CrowdedEdges });
  EXPECT_EQ(surface.mendings[0].ids.kind, ElementKind::Edges);
  EXPECT_EQ(surface.mendings[0].ids.values.size(), 2U * sheetRows);
  Indices part;
  EXPECT_EQ(connectedParts(surface.mesh, {}, part), 2);
  EXPECT_EQ(surface.mesh.triangleCount(), sheet.size());
  EXPECT_EQ(surface.originalPoint[surface.vertexOfPoint[Sheet::at(6, 3)]], Sheet::at(6, 3));
}

TEST(SurfaceHealing, OpensABandThatIsOneSided)
{
  Points3 points;
  Triangles triangles;
  constexpr Index around = 20;
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < 4; ++j)
    {
      const double turn = 2.0 * pi * i / around;
      const double across = 0.2 * (j - 1.5);
      points.emplace_back((2.0 + across * std::cos(0.5 * turn)) * std::cos(turn),
        (2.0 + across * std::cos(0.5 * turn)) * std::sin(turn), across * std::sin(0.5 * turn));
    }
    for (Index j = 0; j < 3; ++j)
    {
      const auto at = [](Index column, Index row) {
        return column < around ? 4 * column + row : 3 - row;
      };
      triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  EXPECT_EQ(healSurface(points, triangles).status.code, StatusCode::NotOrientable);
  const HealedSurface surface =
    healSurface(points, triangles, CoincidentPoints::Automatic, Defects::Separate);
  ASSERT_TRUE(surface.status.ok()) << surface.status.message;
  EXPECT_EQ(defectsOf(surface), DefectMix{ SurfaceDefect::OneSidedEdges });
  EXPECT_EQ(surface.mendings[0].ids.values.size(), 2U * 3U); // once across
  EXPECT_EQ(surface.mesh.triangleCount(), static_cast<Index>(triangles.size()));
  EXPECT_EQ(surface.mesh.boundaryLoops().size(), 1U);
}

TEST(SurfaceHealing, SeparatesAnyTriangles)
{
  std::mt19937 random(7);
  int separated = 0;
  double kept = 0.0; // of the triangles
  for (int k = 0; k < 300; ++k)
  {
    SCOPED_TRACE(k);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    Points3 points;
    for (int p = 0; p < 14; ++p)
    {
      const double x = place(random);
      const double y = place(random);
      points.emplace_back(x, y, place(random));
    }
    std::set<Triangle> triangles;
    while (triangles.size() < 40)
    {
      Indices corners(points.size());
      std::iota(corners.begin(), corners.end(), 0);
      std::shuffle(corners.begin(), corners.end(), random);
      corners.resize(3);
      std::sort(corners.begin(), corners.end());
      triangles.insert({ corners[0], corners[1], corners[2] });
    }
    const HealedSurface surface = healSurface(points, Triangles(triangles.begin(), triangles.end()),
      CoincidentPoints::Automatic, Defects::Separate);
    EXPECT_TRUE(surface.status.ok()) << surface.status.message;
    std::size_t count = surface.mesh.triangleCount();
    for (const Mending& mending : surface.mendings)
    {
      count +=
        mending.ids.kind == ElementKind::Cells && mending.defect != SurfaceDefect::ReversedTriangles
        ? mending.ids.values.size()
        : 0;
    }
    if (surface.status.ok())
    {
      EXPECT_EQ(count, triangles.size()); // none is lost without a word
      kept += static_cast<double>(surface.mesh.triangleCount()) / triangles.size();
      ++separated;
    }
  }
  EXPECT_GT(separated, 290);
  EXPECT_GT(kept / separated, 0.8); // single triangles below a tenth of the largest are fins
}

TEST(SurfaceHealing, DoublesPinchedPoints)
{
  Sheet sheet;
  const Index pinched = Sheet::at(0, 4);
  const Index a = sheet.add(Point3(-0.5, 0.2, 0.0));
  const Index b = sheet.add(Point3(-0.5, 0.6, 0.0));
  sheet.triangles.push_back({ pinched, b, a });
  const HealedSurface surface = healed(sheet, SurfaceDefect::PinchedPoints, { pinched });
  EXPECT_EQ(surface.mendings.size(), 1U);
  EXPECT_EQ(surface.mesh.triangleCount(), sheet.size());
  EXPECT_EQ(surface.mesh.vertexCount(), static_cast<Index>(sheet.points.size()) + 1);
  EXPECT_EQ(std::count(surface.originalPoint.begin(), surface.originalPoint.end(), pinched), 2);
  // It is not split where neighbors are oriented differently.
  std::swap(sheet.triangles[77][0], sheet.triangles[77][1]);
  EXPECT_EQ(healed(sheet, SurfaceDefect::PinchedPoints, { pinched }).mesh.vertexCount(),
    surface.mesh.vertexCount());
  // The point stays with the larger part.
  EXPECT_EQ(surface.mesh.triangle(0)[0], surface.vertexOfPoint[0]);
  EXPECT_NE(surface.mesh.triangles().back()[0], surface.vertexOfPoint[pinched]);
}

TEST(SurfaceHealing, LeavesOutSpecks)
{
  Sheet sheet;
  const Index first = sheet.size();
  for (const double x : { 2.0, 3.0 })
  {
    const Index p = sheet.add(Point3(x, 0.0, 0.0));
    sheet.add(Point3(x + 0.04, 0.0, 0.0));
    sheet.add(Point3(x, 0.04, 0.0));
    sheet.triangles.push_back({ p, p + 1, p + 2 });
  }
  const HealedSurface surface = healed(sheet, SurfaceDefect::Specks, { first, first + 1 });
  EXPECT_EQ(describe(surface.mendings[0]),
    "2 parts below 0.1 % of the largest part's area were left out: 2 triangles (" +
      std::to_string(first) + ", " + std::to_string(first + 1) + ")");
  EXPECT_EQ(surface.mesh.triangles(), Sheet().triangles);
  // A larger one is a part.
  sheet.points.back() = Point3(3.0, 0.1, 0.0);
  EXPECT_EQ(healSurface(sheet.points, sheet.triangles).mesh.triangleCount(), first + 1);
}

TEST(SurfaceHealing, RefusesWhatHasNothingLeft)
{
  Sheet sheet;
  for (Point3& p : sheet.points)
  {
    p = Point3(p.x(), 0.0, 0.0);
  }
  const HealedSurface surface = healSurface(sheet.points, sheet.triangles);
  EXPECT_EQ(surface.status.code, StatusCode::DegenerateTriangle);
  EXPECT_EQ(surface.status.ids.values.size(), static_cast<std::size_t>(sheet.size()));
}

TEST(SurfaceHealing, KeepsToTheSameWhateverOrderAndSizeTrianglesHave)
{
  Sheet sheet;
  sheet.points[Sheet::at(3, 3)] = sheet.points[Sheet::at(3, 4)];
  sheet.points[Sheet::at(8, 6)] =
    0.5 * (sheet.points[Sheet::at(7, 6)] + sheet.points[Sheet::at(9, 6)]);
  sheet.triangles.push_back({ Sheet::at(9, 2), Sheet::at(9, 3), sheet.add(Point3(0.8, 0.2, 0.9)) });
  sheet.triangles.push_back({ Sheet::at(7, 6), Sheet::at(8, 6), Sheet::at(9, 6) });
  const HealedSurface straight = healSurface(sheet.points, sheet.triangles);
  ASSERT_TRUE(straight.status.ok()) << straight.status.message;
  std::mt19937 random(7);
  for (const double scale : { 1.0, 0x1p-40, 0x1p40 })
  {
    Indices order(sheet.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    Sheet mixed = sheet;
    for (Index t = 0; t < sheet.size(); ++t)
    {
      mixed.triangles[t] = sheet.triangles[order[t]];
    }
    for (Point3& p : mixed.points)
    {
      p *= scale;
    }
    const HealedSurface surface = healSurface(mixed.points, mixed.triangles);
    ASSERT_TRUE(surface.status.ok()) << surface.status.message;
    ASSERT_EQ(defectsOf(surface), defectsOf(straight));
    for (std::size_t k = 0; k < straight.mendings.size(); ++k)
    {
      std::vector<std::int64_t> ids = surface.mendings[k].ids.values;
      for (std::int64_t& id : ids)
      {
        id = surface.mendings[k].ids.kind == ElementKind::Cells ? order[id] : id;
      }
      std::sort(ids.begin(), ids.end());
      EXPECT_EQ(ids, straight.mendings[k].ids.values);
    }
    const auto sorted = [](const HealedSurface& of) {
      std::vector<Indices> cells;
      for (const Triangle& t : of.mesh.triangles())
      {
        Indices cell{ of.originalPoint[t[0]], of.originalPoint[t[1]], of.originalPoint[t[2]] };
        std::sort(cell.begin(), cell.end());
        cells.push_back(cell);
      }
      std::sort(cells.begin(), cells.end());
      return cells;
    };
    EXPECT_EQ(sorted(surface), sorted(straight));
  }
}
