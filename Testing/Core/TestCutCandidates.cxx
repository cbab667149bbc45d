// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutCandidates.h"
#include "TestMeshes.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
SearchedPiece plainPiece(const TriangleMesh& mesh)
{
  return { mesh, std::vector<char>(mesh.vertexCount(), 0), {}, {}, std::nullopt };
}

double highest(const Polyline& line)
{
  double top = -1.0;
  for (const Point3& p : line.points)
  {
    top = std::max(top, p.z());
  }
  return top;
}
}

TEST(CutCandidates, HaveSeamsOverTheTopOfADeepCap)
{
  // Between two places of its boundary, a circle of 30 degrees about the lower pole, the shortest
  // way stays near that circle; only a seam over a place of the inside divides it.
  const TriangleMesh mesh = sphereCap(150.0 * pi / 180.0, 12, 0).mesh;
  const SearchedPiece piece = plainPiece(mesh);
  const ScaleFactor factor(mesh, {}, {});
  ASSERT_TRUE(factor.ok());
  SearchOptions options;
  options.cuts = SuggestedCuts::Seams;
  double shortest = -1.0;
  double over = -1.0;
  for (const CutPlan& plan : planCuts(piece, factor, options, 1e9, {}))
  {
    const std::vector<Polyline> lines = piece.polylines(plan);
    ASSERT_EQ(lines.size(), 1U);
    if (plan.via)
    {
      EXPECT_GE(highest(lines[0]), plan.via->z() - 1e-9);
      over = std::max(over, highest(lines[0]));
    }
    else
    {
      shortest = std::max(shortest, highest(lines[0]));
    }
  }
  EXPECT_LT(shortest, 0.0);
  EXPECT_GT(over, 0.9);
}

TEST(CutCandidates, LinesTakeNoTimeThatGrowsWithTheMesh)
{
  constexpr Index side = 300;
  const TriangleMesh mesh = unitSquares(side, side).mesh;
  const SearchedPiece piece = plainPiece(mesh);
  constexpr int times = 50;
  const double lines = secondsOf([&] {
    for (int k = 0; k < times; ++k)
    {
      CutPlan plan;
      plan.base = piece.ruler().placeOf(side / 2 + k);
      plan.tip = mesh.point(side / 2 + k) + Point3(0.3, 1.2, 0.0);
      EXPECT_EQ(piece.polylines(plan).size(), 1U);
    }
  });
  const double distances = secondsOf([&] {
    for (int k = 0; k < times; ++k)
    {
      EXPECT_GT(SnapDistance(mesh, 1e-3).greatest(), 0.0);
    }
  });
  EXPECT_LT(lines, distances / 2.0);
}

TEST(CutCandidates, DartsAcrossTheirEdgeAreCheapest)
{
  const TriangleMesh mesh = unitSquares(12, 12).mesh;
  const SearchedPiece piece = plainPiece(mesh);
  const SearchOptions options;
  const Index base = 6; // in the middle of the side where j = 0
  const Point3 side = (mesh.point(12) - mesh.point(0)).normalized();
  const Point3 across = (mesh.point(12 * 13) - mesh.point(0)).normalized();
  const auto priceAt = [&](double degrees) {
    const double angle = degrees * pi / 180.0;
    CutPlan plan;
    plan.base = piece.ruler().placeOf(base);
    plan.tip =
      mesh.point(base) + 0.3 * piece.size() * (std::cos(angle) * side + std::sin(angle) * across);
    return piece.price(plan, 0.3 * piece.size(), options);
  };
  EXPECT_NEAR(priceAt(90.0), (options.fixedPrice + 0.3) * piece.size(), 1e-12);
  EXPECT_NEAR(priceAt(45.0), std::sqrt(2.0) * priceAt(90.0), 1e-9);
  EXPECT_NEAR(priceAt(135.0), priceAt(45.0), 1e-9);
  EXPECT_NEAR(priceAt(10.0), 2.0 * priceAt(90.0), 1e-9);
}
