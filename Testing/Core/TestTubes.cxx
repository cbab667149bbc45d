// SPDX-License-Identifier: BSD-3-Clause
// Sleeves and whole garments, which no plane can hold: what is said of them and what becomes of
// them.
#include "ClosedMeshes.h"
#include "Cloth/ClothMaterial.h"
#include "Flattened.h"
#include "Quality/AreaForecast.h"
#include "StatusTesting.h"

#include <set>

using namespace flattening;
using namespace statustesting;
using namespace testmeshes;

namespace
{
/// Square arms along the axes around a cube, as many of them open at their ends.
TriangleMesh garment(Index open, Index length, Index division, double size)
{
  using Cell = std::array<Index, 3>;
  const std::array<Cell, 6> ways{ { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
    { 0, 0, 1 }, { 0, 0, -1 } } };
  const auto moved = [](const Cell& from, const Cell& way, Index by) {
    return Cell{ from[0] + by * way[0], from[1] + by * way[1], from[2] + by * way[2] };
  };
  std::set<Cell> cubes{ { 0, 0, 0 } };
  for (const Cell& way : ways)
  {
    for (Index k = 1; k <= length; ++k)
    {
      cubes.insert(moved({ 0, 0, 0 }, way, k));
    }
  }
  std::vector<Surface> squares;
  for (const Cell& cube : cubes)
  {
    for (std::size_t w = 0; w < ways.size(); ++w)
    {
      const bool end = cube == moved({ 0, 0, 0 }, ways[w], length);
      if (cubes.count(moved(cube, ways[w], 1)) > 0 || (end && static_cast<Index>(w) < open))
      {
        continue;
      }
      // Along two axes that make a right-handed system with the way outwards.
      const std::size_t axis = w / 2;
      const std::size_t first = (axis + 1 + w % 2) % 3;
      const std::size_t second = (axis + 2 - w % 2) % 3;
      squares.push_back(patch(division, division, [&](double i, double j) -> Point3 {
        Point3 at = 2.0 * division * Point3(cube[0], cube[1], cube[2]);
        at[axis] += division * ways[w][axis];
        at[first] += 2.0 * i - division;
        at[second] += 2.0 * j - division;
        return size * at;
      }));
    }
  }
  const TriangleMesh apart = together(squares).mesh;
  return prepareSurface(apart.points(), apart.triangles(), CoincidentPoints::Join).mesh;
}

FlatteningResult flatten(const TriangleMesh& mesh, const FlatteningOptions& options = {},
  const std::vector<FeatureCurve>& curves = {})
{
  return flattenSurface(mesh, curves, options, {});
}

/// Every path runs along inner edges from one boundary loop to another.
void expectPaths(const TriangleMesh& mesh, const std::vector<Indices>& paths)
{
  for (const Indices& path : paths)
  {
    ASSERT_GE(path.size(), 2U);
    EXPECT_TRUE(mesh.onBoundary(path.front()));
    EXPECT_TRUE(mesh.onBoundary(path.back()));
    for (std::size_t k = 1; k < path.size(); ++k)
    {
      const Index h = mesh.find(path[k - 1], path[k]);
      ASSERT_NE(h, none);
      EXPECT_NE(mesh.twin(h), none);
    }
  }
}
}

TEST(Tubes, AreKnownByTheTurnsOfTheirOpenings)
{
  for (const double size : { 1e-3, 1.0, 1e4 })
  {
    for (const double length : { 0.2, 3.0 })
    {
      // The wall's slope against the axis: a narrow ring loses 1 - slope / sqrt(1 + slope^2).
      for (const auto& [slope, tube] : { std::pair(0.0, true), std::pair(0.9, true),
             std::pair(1.1, false), std::pair(3.0, false) })
      {
        const TriangleMesh mesh = revolved(24, 5, size * length,
          [&, slope = slope](double share) { return size * (1.0 + slope * length * share); });
        const AreaForecast forecast = forecastArea(mesh, {});
        EXPECT_EQ(forecast.tube(), tube) << slope;
        EXPECT_EQ(forecast.openings.size(), tube ? 1U : 0U);
        expectPaths(mesh, forecast.openings);
      }
    }
  }
}

TEST(Tubes, HaveHolesThatAreNoOpenings)
{
  const TriangleMesh whole = revolved(24, 16, 3.2);
  Triangles triangles = whole.triangles();
  triangles.erase(triangles.begin() + 350);
  const TriangleMesh holed(whole.points(), triangles);
  ASSERT_EQ(holed.boundaryLoops().size(), 3U);
  EXPECT_EQ(forecastArea(holed, {}).openings.size(), 1U);
}

TEST(Tubes, KeepTheLengthsOfAllTheirOpenings)
{
  // Along the longest arms a convex map falls below what rounding leaves of its largest triangles.
  struct Case
  {
    Index open;
    Index length;
    double size;
  };
  for (const auto& [open, length, size] :
    { Case{ 2, 1, 0.01 }, Case{ 2, 9, 30.0 }, Case{ 3, 4, 30.0 }, Case{ 3, 9, 0.01 },
      Case{ 5, 1, 1.0 }, Case{ 5, 7, 1.0 }, Case{ 6, 4, 0.01 }, Case{ 6, 9, 30.0 } })
  {
    SCOPED_TRACE(std::to_string(open) + " openings, arms of " + std::to_string(length));
    const TriangleMesh mesh = garment(open, length, 2, size);
    ASSERT_EQ(mesh.boundaryLoops().size(), static_cast<std::size_t>(open));
    const FlatteningResult result = flatten(mesh);
    const PieceReport& piece = result.pieces.front();
    EXPECT_LE(piece.quality.maximumEdgeLengthError, 1e-9) << result.status.message;
    EXPECT_TRUE(piece.quality.flipped.empty());
    EXPECT_EQ(piece.area.openings.size(), static_cast<std::size_t>(open - 1));
    if (!result.status.ok())
    {
      EXPECT_TRUE(has(result.status, Remedy::SeamBetweenLoops)) << result.status.message;
      EXPECT_FALSE(has(result.status, Remedy::AddDarts)) << result.status.message;
      EXPECT_FALSE(has(result.status, Remedy::ReleaseCurves)) << result.status.message;
    }
  }
}

TEST(Tubes, AreDisksOnceTheyAreCutAsProposed)
{
  for (const Index open : { 2, 3, 6 })
  {
    const TriangleMesh mesh = garment(open, 2, 3, 1.0);
    std::vector<FeatureCurve> seams;
    for (const Indices& path : forecastArea(mesh, {}).openings)
    {
      seams.push_back(curveOf(CurveType::Seam, "seam " + std::to_string(seams.size()), path));
    }
    const FlatteningResult result = flatten(mesh, withScheme(Scheme::LeastSquaresConformal), seams);
    ASSERT_EQ(result.pieces.size(), 1U) << result.status.message;
    EXPECT_EQ(result.pieces.front().boundaryLoops, 1);
  }
}

TEST(Tubes, AreToldBeforeTheLongWork)
{
  for (const bool closed : { true, false })
  {
    // A tube, or half of it.
    const TriangleMesh whole = garment(2, 2, 2, 1.0);
    const TriangleMesh half = patch(12, 6, [](double i, double j) {
      return Point3(std::cos(i / 4.0), std::sin(i / 4.0), j);
    }).mesh;
    std::vector<std::string> phases;
    Execution execution;
    execution.progress = [&phases](double, const char* phase) { phases.emplace_back(phase); };
    flattenSurface(closed ? whole : half, {}, {}, execution);
    const auto told =
      std::find(phases.begin(), phases.end(), "Flattening a piece that no plane can hold");
    EXPECT_EQ(told != phases.end(), closed);
    const auto work =
      std::find(phases.begin(), phases.end(), "Warping wires and interior together");
    EXPECT_LE(told, closed ? work : phases.end());
  }
}

TEST(Tubes, WithoutAnOpeningAreRefusedBeforeAnyPieceIsFlattened)
{
  const Surface closed = { garment(0, 1, 2, 1.0), {}, {} };
  const Surface sheet = movedRigidly(unitSquares(4, 4));
  std::set<std::string> phases;
  Execution execution;
  execution.progress = [&phases](double, const char* phase) { phases.insert(phase); };
  const TriangleMesh mesh = together({ sheet, closed, sheet }).mesh;
  EXPECT_EQ(flattenSurface(mesh, {}, {}, execution).status.code, StatusCode::ClosedSurface);
  EXPECT_EQ(phases, std::set<std::string>{ "Cutting darts and seams" });
}

TEST(Tubes, OfManyTrianglesAreMappedAtOnceAndSaySo)
{
  for (const Index open : { 2, 5 })
  {
    const TriangleMesh mesh = garment(open, 3, 12, 2.0);
    ASSERT_GT(mesh.triangleCount(), 20000);
    for (const bool cloth : { false, true })
    {
      FlatteningOptions options;
      if (cloth)
      {
        options.cloth.emplace().material = *findPreset("twill");
      }
      FlatteningResult result;
      EXPECT_LT(secondsOf([&] { result = flatten(mesh, options); }), 10.0);
      ASSERT_EQ(result.pieces.size(), 1U);
      const PieceReport& piece = result.pieces.front();
      EXPECT_EQ(result.status.code, StatusCode::LengthError);
      EXPECT_NE(result.status.message.find("the piece is a tube"), std::string::npos);
      EXPECT_TRUE(has(result.status, Remedy::SeamBetweenLoops)) << result.status.message;
      EXPECT_FALSE(has(result.status, Remedy::ReleaseCurves)) << result.status.message;
      EXPECT_EQ(piece.area.openings.size(), static_cast<std::size_t>(open - 1));
      EXPECT_TRUE(piece.quality.flipped.empty());
      EXPECT_TRUE(piece.isometricHistory.empty());
      EXPECT_TRUE(piece.fallbacks.empty());
    }
  }
}
