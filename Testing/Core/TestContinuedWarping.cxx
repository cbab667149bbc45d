// SPDX-License-Identifier: BSD-3-Clause
// Flattenings that go on from where the surface lay before another cut was made.
#include "Flattened.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A lopsided dome of 16 by 16 cells over a square. Its flattening has one minimum.
TriangleMesh dome()
{
  return patch(16, 16, [](double i, double j) {
    const double x = i / 8.0 - 1.0;
    const double y = j / 8.0 - 1.0;
    return Point3(x, y, (0.5 + 0.1 * x) * (1.0 - x * x) * (1.0 - 0.8 * y * y));
  }).mesh;
}

/// From the middle of the side j = 0 into the dome.
FeatureCurve dart()
{
  return curveOf(CurveType::Dart, "dart", { 8, 25, 42, 59, 76, 93, 110 });
}

std::vector<FlatCorners> cornersOf(const FlatteningResult& flat)
{
  std::vector<FlatCorners> corners;
  for (const auto& [a, b, c] : flat.cut->mesh.triangles())
  {
    corners.push_back({ flat.positions[a], flat.positions[b], flat.positions[c] });
  }
  return corners;
}
}

TEST(ContinuedWarping, ComesToTheMinimumThatTheWiresAnglesLeadTo)
{
  const TriangleMesh mesh = dome();
  const FlatteningResult uncut = flattenSurface(mesh, {}, {}, {});
  FlatteningOptions options;
  options.start = cornersOf(uncut);
  const FlatteningResult continued = flattenSurface(mesh, { dart() }, options, {});
  const FlatteningResult anew = flattenSurface(mesh, { dart() }, {}, {});
  ASSERT_TRUE(continued.status.ok()) << continued.status.message;
  ASSERT_TRUE(anew.status.ok());
  EXPECT_TRUE(continued.pieces[0].history.empty()); // no angles were solved for
  EXPECT_FALSE(anew.pieces[0].history.empty());
  const double energy = anew.pieces[0].quality.rigidEnergy;
  EXPECT_LT(energy, 0.9 * uncut.pieces[0].quality.rigidEnergy);
  EXPECT_NEAR(continued.pieces[0].quality.rigidEnergy, energy, 1e-7 * energy);
  EXPECT_NEAR(continued.pieces[0].quality.strainP95, anew.pieces[0].quality.strainP95, 1e-7);
  EXPECT_LT(worstLength(continued), 1e-9);
}

TEST(ContinuedWarping, KeepsLengthsWhereItEndsBeforeWiresAreSettled)
{
  const TriangleMesh mesh = dome();
  FlatteningOptions options;
  options.start = cornersOf(flattenSurface(mesh, {}, {}, {}));
  const FlatteningResult settled = flattenSurface(mesh, { dart() }, options, {});
  options.isometric.rough = true;
  const FlatteningResult rough = flattenSurface(mesh, { dart() }, options, {});
  EXPECT_LT(rough.pieces[0].isometricHistory.size(), settled.pieces[0].isometricHistory.size());
  const double energy = settled.pieces[0].quality.rigidEnergy;
  EXPECT_NEAR(rough.pieces[0].quality.rigidEnergy, energy, 0.3 * energy);
  EXPECT_LT(worstLength(rough), 1e-9);
}

TEST(ContinuedWarping, IsNotForPiecesWhoseKeysHoldMoreThanLengths)
{
  const TriangleMesh mesh = dome();
  const FeatureCurve key = rowCurve(16, 10, CurveType::Key);
  FlatteningOptions options;
  options.start = cornersOf(flattenSurface(mesh, {}, {}, {}));
  const FlatteningResult continued = flattenSurface(mesh, { key, dart() }, options, {});
  const FlatteningResult anew = flattenSurface(mesh, { key, dart() }, {}, {});
  EXPECT_EQ(continued.positions, anew.positions);
}

TEST(ContinuedWarping, StartsAnewWhereTheStartIsFolded)
{
  const TriangleMesh mesh = dome();
  FlatteningOptions options;
  options.start.assign(mesh.triangleCount(), { Point2(0, 0), Point2(0, 1), Point2(1, 0) });
  const FlatteningResult continued = flattenSurface(mesh, { dart() }, options, {});
  EXPECT_EQ(continued.positions, flattenSurface(mesh, { dart() }, {}, {}).positions);
}
