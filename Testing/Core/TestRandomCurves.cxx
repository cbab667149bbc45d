// SPDX-License-Identifier: BSD-3-Clause
// Seeded random curve sets of all types on one surface.
#include "Flattened.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Walks along random edges of the mesh; they cross, touch and retrace each other as chance has it.
std::vector<FeatureCurve> randomCurves(const TriangleMesh& mesh, unsigned seed, bool keys)
{
  std::mt19937 random(seed);
  std::vector<FeatureCurve> curves;
  const Index count = 1 + static_cast<Index>(random() % 6);
  for (Index c = 0; c < count; ++c)
  {
    auto type = static_cast<CurveType>(random() % 4);
    if (type == CurveType::Key && !keys)
    {
      type = CurveType::Accessory;
    }
    Indices chain{ static_cast<Index>(random() % mesh.vertexCount()) };
    const std::size_t steps = 1 + random() % 12;
    while (chain.size() <= steps)
    {
      Indices neighbours;
      for (Index h = 0; h < mesh.halfedgeCount(); ++h)
      {
        if (mesh.from(h) == chain.back())
        {
          neighbours.push_back(mesh.to(h));
        }
        else if (mesh.to(h) == chain.back() && mesh.twin(h) == none)
        {
          neighbours.push_back(mesh.from(h));
        }
      }
      chain.push_back(neighbours[random() % neighbours.size()]);
    }
    curves.push_back(curveOf(type, "c" + std::to_string(c), std::move(chain)));
  }
  return curves;
}

FlatteningOptions optionsOf(unsigned seed)
{
  FlatteningOptions options;
  options.scheme = seed % 2 == 0 ? Scheme::Global : Scheme::Progressive;
  options.angles.method = seed % 3 == 0 ? AngleMethod::Sequential : AngleMethod::Newton;
  options.arrange = false;
  return options;
}
}

TEST(RandomCurves, FlatSurfacesFlattenToThemselves)
{
  Surface surface = flatPatch(7, 6);
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    surface.curves = randomCurves(surface.mesh, seed, true);
    const FlatteningResult result = flatten(surface, optionsOf(seed));
    // Cuts in a flat sheet leave banks that touch; they are no overlap.
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    for (const PieceReport& piece : result.pieces)
    {
      EXPECT_LT(piece.objective, 1e-20);
    }
    EXPECT_LT(worstPiece(surface, result), 1e-9);
  }
}

TEST(RandomCurves, WiresOfACurvedSurfaceMeet)
{
  Surface surface = cushion(7, 6, 0.12);
  int converged = 0;
  const unsigned count = 300;
  for (unsigned seed = 0; seed < count; ++seed)
  {
    SCOPED_TRACE(seed);
    surface.curves = randomCurves(surface.mesh, seed, false);
    FlatteningOptions options = optionsOf(seed);
    options.angles.method = AngleMethod::Newton;
    const FlatteningResult result = flatten(surface, options);
    ASSERT_FALSE(result.status.refused()) << result.status.message;
    for (const Point2& p : result.positions)
    {
      ASSERT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
    }
    const double worst = worstLength(result);
    // Whoever reads the status is never told that all is well when it is not.
    if (result.status.ok())
    {
      EXPECT_LT(worst, 1e-10);
    }
    converged += worst < 1e-10 ? 1 : 0;
  }
  EXPECT_EQ(converged, static_cast<int>(count));
}
