// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutCandidates.h"

#include "SphereCap.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace flattening;
using namespace testmeshes;

namespace
{
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
  const SearchedPiece piece(mesh, std::vector<char>(mesh.vertexCount(), 0), {}, {}, std::nullopt);
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
