// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
FlatteningResult flatten(double tolerance, Scheme scheme)
{
  Surface surface = quarterSphere();
  surface.curves[0].tolerance = tolerance;
  FlatteningOptions options = withScheme(scheme);
  options.interior.method = InteriorMethod::Laplacian;
  return flatten(surface, options);
}
}

TEST(ElasticCurves, StayInTheirBandWhileRigidOnesStayExact)
{
  for (const Scheme scheme : { Scheme::Global, Scheme::Progressive, Scheme::Isometric })
  {
    for (const double tolerance : { 0.01, 0.05, 0.3 })
    {
      const FlatteningResult result = flatten(tolerance, scheme);
      ASSERT_FALSE(result.status.refused()) << result.status.message;
      EXPECT_STRNE(statusName(result.status.code), "NotConverged");
      EXPECT_STRNE(statusName(result.status.code), "LengthError");
      ASSERT_EQ(result.curves.size(), 1U);
      EXPECT_LE(result.curves[0].error, tolerance * (1.0 + 1e-9));
      EXPECT_GT(result.curves[0].error, 1e-3) << "the band is of use here";
      EXPECT_LT(result.pieces.front().quality.maximumEdgeLengthError, 1e-12);
      for (const Wire& wire : result.wires)
      {
        if (wire.boundary)
        {
          EXPECT_LT(wire.maximumEdgeError, 1e-12);
        }
      }
    }
  }
}

TEST(ElasticCurves, TheWiderTheBandTheLowerTheObjective)
{
  double previous = flatten(0.0, Scheme::Global).pieces.front().objective;
  EXPECT_NEAR(previous, 0.197157, 5e-7);
  for (const double tolerance : { 0.01, 0.03, 0.1 })
  {
    const double objective = flatten(tolerance, Scheme::Global).pieces.front().objective;
    EXPECT_LT(objective, previous);
    previous = objective;
  }
}

TEST(ElasticCurves, OfAFlatSurfaceKeepTheirLength)
{
  Surface surface = flatPatch(6, 6);
  surface.curves = { rowCurve(6, 3), columnCurve(6, 6, 2) };
  surface.curves[0].tolerance = 0.1;
  const FlatteningResult result = flatten(surface);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LT(result.curves[0].error, 1e-10);
  EXPECT_LT(rigidDistance(result.positions, surface.unrolled), 1e-9);
}

TEST(ElasticCurves, ASeamBetweenTwoPiecesIsAsLongOnBothSides)
{
  // One half of the surface is curved more than the other, so each by itself would choose another
  // length.
  Surface surface = cushion(10, 8, 0.5);
  surface.curves = { columnCurve(10, 8, 3, CurveType::Seam), rowCurve(10, 4) };
  surface.curves[0].tolerance = 0.05;
  for (const Scheme scheme : { Scheme::Global, Scheme::Progressive, Scheme::Isometric })
  {
    SCOPED_TRACE(static_cast<int>(scheme));
    const FlatteningResult result = flatten(surface, withScheme(scheme));
    ASSERT_FALSE(result.status.refused()) << result.status.message;
    ASSERT_EQ(result.pieces.size(), 2U);
    const TriangleMesh& mesh = result.cut->mesh;
    const auto length = [&](Index h) {
      return (result.positions[mesh.to(h)] - result.positions[mesh.from(h)]).norm();
    };
    for (const SeamPair& pair : result.cut->seamPairs)
    {
      EXPECT_NEAR(length(pair.first) / length(pair.second), 1.0, 1e-12);
    }
    EXPECT_LE(result.curves[0].error, 0.05 * (1.0 + 1e-9));
    EXPECT_GT(result.curves[0].error, 1e-4) << "the band is of use here";
    EXPECT_LT(result.curves[1].error, 1e-12);
  }
}
