// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SideSeams.h"

#include "SuggestionTesting.h"

#include <map>
#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
using Place = std::pair<int, int>;

/// Two sheets over the squares of a lattice, joined along their outline but for openings, and
/// farther from each other the farther they are from there.
/// \param opens whether the edge of the outline with this middle is of an opening
TriangleMesh garment(
  const std::set<Place>& squares, const std::function<bool(double x, double y)>& opens)
{
  std::set<Place> joined;
  for (const auto& [x, y] : squares)
  {
    for (const auto& [dx, dy] : { Place(1, 0), Place(-1, 0), Place(0, 1), Place(0, -1) })
    {
      if (squares.count({ x + dx, y + dy }) == 0 && !opens(x + 0.5 + 0.5 * dx, y + 0.5 + 0.5 * dy))
      {
        joined.insert({ x + (dx > 0 ? 1 : 0), y + (dy > 0 ? 1 : 0) });
        joined.insert({ x + (dx < 0 ? 0 : 1), y + (dy < 0 ? 0 : 1) });
      }
    }
  }
  Points3 points;
  std::map<std::pair<Place, int>, Index> numbers;
  const auto vertex = [&](Place place, int side) {
    double apart = 1e9;
    for (const auto& [x, y] : joined)
    {
      apart = std::min(apart, std::hypot(x - place.first, y - place.second));
    }
    const auto [found, isNew] =
      numbers.try_emplace({ place, apart > 0.0 ? side : 0 }, static_cast<Index>(points.size()));
    if (isNew)
    {
      points.push_back({ double(place.first), double(place.second), 0.15 * side * apart });
    }
    return found->second;
  };
  Triangles triangles;
  for (const auto& [x, y] : squares)
  {
    for (int side : { 1, -1 })
    {
      const Index a = vertex({ x, y }, side);
      const Index b = vertex({ x + (side > 0 ? 1 : 0), y + (side > 0 ? 0 : 1) }, side);
      const Index c = vertex({ x + 1, y + 1 }, side);
      const Index d = vertex({ x + (side > 0 ? 0 : 1), y + (side > 0 ? 1 : 0) }, side);
      triangles.push_back({ a, b, c });
      triangles.push_back({ a, c, d });
    }
  }
  return TriangleMesh(std::move(points), std::move(triangles));
}

/// The squares from x = -half to half and y = 0 to top that a function keeps.
std::set<Place> squaresOf(int half, int top, const std::function<bool(int x, int y)>& isKept)
{
  std::set<Place> squares;
  for (int x = -half; x < half; ++x)
  {
    for (int y = 0; y < top; ++y)
    {
      if (isKept(x, y))
      {
        squares.insert({ x, y });
      }
    }
  }
  return squares;
}

/// With neck, hem and two sleeves.
TriangleMesh shirt()
{
  return garment(squaresOf(12, 15, [](int x, int y) { return y >= 10 || std::abs(x + 0.5) < 5; }),
    [](double x, double y) {
      return y == 0.0 || std::abs(x) == 12.0 || (y == 15.0 && std::abs(x) < 3.0);
    });
}

TriangleMesh trousers()
{
  return garment(squaresOf(6, 20, [](int x, int y) { return y >= 14 || std::abs(x + 0.5) >= 2; }),
    [](double, double y) { return y == 0.0 || y == 20.0; });
}

TriangleMesh skirt()
{
  return garment(squaresOf(5, 14, [](int, int) { return true; }),
    [](double, double y) { return y == 0.0 || y == 14.0; });
}

std::optional<SurfaceMirror> mirrorOf(const TriangleMesh& mesh)
{
  return SurfaceMirror(measuredPlane(mesh, SymmetryPlane{ Point3::UnitX(), 0.0 }));
}

/// Each seam lies where the sheets are joined, and they part the surface into both.
void expectSheets(const TriangleMesh& mesh, const std::vector<SuggestedCurve>& seams)
{
  std::vector<Polyline> lines;
  for (const SuggestedCurve& seam : seams)
  {
    lines.push_back(seam.curve);
    for (const Point3& point : seam.curve.points)
    {
      EXPECT_NEAR(point.z(), 0.0, 0.2) << point.transpose();
    }
  }
  const ImprintedSurface surface = imprintCurves(mesh, lines, {});
  ASSERT_TRUE(surface.status.ok()) << surface.status.message;
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  ASSERT_EQ(cut.pieceCount, 2);
  for (const Piece& piece : extractPieces(cut))
  {
    EXPECT_EQ(eulerCharacteristic(piece.mesh), 1);
    EXPECT_NEAR(piece.mesh.area(), 0.5 * mesh.area(), 0.02 * mesh.area());
  }
}
}

TEST(SideSeams, PartAGarmentIntoFrontAndBackInPairsOfEqualLength)
{
  const struct
  {
    TriangleMesh mesh;
    std::size_t seams;
  } cases[] = { { skirt(), 2 }, { trousers(), 3 }, { shirt(), 4 } };
  for (const auto& [mesh, count] : cases)
  {
    for (bool mirrored : { true, false })
    {
      SCOPED_TRACE(count + (mirrored ? 10 : 0));
      const std::vector<SuggestedCurve> seams =
        sideSeams(mesh, mirrored ? mirrorOf(mesh) : std::nullopt);
      ASSERT_EQ(seams.size(), count);
      expectSheets(mesh, seams);
      std::size_t pairs = 0;
      for (const SuggestedCurve& seam : seams)
      {
        if (seam.mirrorOf != none)
        {
          ++pairs;
          EXPECT_NEAR(seam.length, seams[seam.mirrorOf].length, 1e-12 * seam.length);
        }
      }
      EXPECT_TRUE(!mirrored || count != 4 || pairs == 2);
    }
  }
}

TEST(SideSeams, AreOfSurfacesWithTwoOpenings)
{
  EXPECT_TRUE(sideSeams(cushion(6, 6, 0.4).mesh, {}).empty());
  EXPECT_TRUE(sideSeams(torus(14, 3.0), {}).empty());
}

TEST(SideSeams, AreProposedFirst)
{
  // Shallow sheets lie flat within the bound, and no seam but those along the outline is needed.
  const CurveSuggestions suggestions = suggestCurves(trousers(), {}, optionsOf(0.05, 0));
  EXPECT_TRUE(suggestions.boundMet);
  ASSERT_EQ(suggestions.curves.size(), 3u);
  expectSheets(trousers(), suggestions.curves);
}

TEST(SideSeams, AreNotProposedWhereFewerOpenATube)
{
  // The neckline of a flat shirt is a hole, and its sleeves and shoulders fold.
  const CurveSuggestions suggestions = suggestCurves(shirt(), {}, optionsOf(0.05, 0));
  EXPECT_TRUE(suggestions.boundMet);
  EXPECT_EQ(suggestions.curves.size(), 2u);
}
