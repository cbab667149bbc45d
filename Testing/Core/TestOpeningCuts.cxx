// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/OpeningCuts.h"

#include "Cut/PieceTopology.h"
#include "SuggestionTesting.h"

using namespace flattening;
using namespace testmeshes;

TEST(OpeningCuts, MakeADiskOfATorus)
{
  const TriangleMesh mesh = torus(14, 3.0);
  const ImprintedSurface surface = imprintCurves(mesh, openingCuts(mesh), {});
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  EXPECT_EQ(cut.pieceCount, 1);
  EXPECT_EQ(eulerCharacteristic(cut.mesh), 1);
  EXPECT_EQ(cut.mesh.boundaryLoops().size(), 1u);
}

TEST(OpeningCuts, JoinTheEndsOfATubeAndLeaveASmallHole)
{
  const auto tube = [](Index missing) {
    const TriangleMesh whole = revolved(24, 16, 3.2);
    Triangles triangles = whole.triangles();
    triangles.erase(triangles.begin() + 350, triangles.begin() + 350 + missing);
    return TriangleMesh(whole.points(), triangles);
  };
  EXPECT_EQ(openingCuts(tube(0)).size(), 1u);
  const TriangleMesh holed = tube(1);
  ASSERT_EQ(holed.boundaryLoops().size(), 3u);
  const ImprintedSurface surface = imprintCurves(holed, openingCuts(holed), {});
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  EXPECT_EQ(cut.mesh.boundaryLoops().size(), 2u);
}

TEST(OpeningCuts, LeaveAWideHoleInASheetThatLiesFlat)
{
  // A ring on a drum: outer edge and hole, half as wide, turn by 2 pi and -2 pi wherever it is
  // bent.
  const auto ring = [](double bend) {
    return rolledUp(30, 6, [=](double turn, double across) {
      const double x = (1.0 + across) * std::cos(turn);
      const double y = (1.0 + across) * std::sin(turn);
      return bend > 0.0 ? Point3(std::sin(bend * x) / bend, y, (1.0 - std::cos(bend * x)) / bend)
                        : Point3(x, y, 0.0);
    });
  };
  for (double bend : { 0.0, 0.2 })
  {
    EXPECT_TRUE(openingCuts(ring(bend)).empty());
    const CurveSuggestions suggestions = suggestCurves(ring(bend), {}, optionsOf(0.02, 8));
    EXPECT_TRUE(suggestions.boundMet);
    EXPECT_TRUE(suggestions.curves.empty());
  }
}

TEST(OpeningCuts, JoinTheEndsOfAFrustum)
{
  // Its edges turn by less than a hole's: by the sine of the angle between its wall and its axis.
  const auto frustum = [](double share) { return 1.0 + share; };
  EXPECT_EQ(openingCuts(revolved(30, 6, 1.0, frustum)).size(), 1u);
}

TEST(OpeningCuts, KeepOffKeyCurves)
{
  // Straight across the tube all ways are equally long, and the key takes half of one end.
  const TriangleMesh tube = revolved(24, 6, 1.0);
  Indices half(13);
  std::iota(half.begin(), half.end(), 0);
  const Polyline key = lineOver(tube, half, CurveType::Key);
  const CurveSuggestions suggestions = suggestCurves(tube, { key }, optionsOf(0.02, 4));
  ASSERT_EQ(suggestions.curves.size(), 1u);
  EXPECT_TRUE(suggestions.boundMet);
  EXPECT_LT(suggestions.strainAfter, 1e-6);
}
