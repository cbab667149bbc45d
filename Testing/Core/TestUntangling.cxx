// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/Untangling.h"

#include "Quality/FlatteningQuality.h"
#include "WiredSurface.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Per vertex of the piece.
Points2 unrolled(const WiredSurface& wired, const Surface& surface)
{
  Points2 positions;
  for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
  {
    positions.push_back(surface.unrolled[wired.original(v)]);
  }
  return positions;
}

/// A flat patch whose interior is scattered, and whose wires are bent into a deep notch.
Points2 tangledPositions(const WiredSurface& wired, const Points2& flat, double notch)
{
  Points2 positions;
  for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
  {
    const Point2 p = flat[wired.original(v)];
    const bool onWire = wired.network.hostOfVertex[v] != none;
    const Point2 bent(p.x(), p.y() - notch * std::exp(-(p.x() - 5.0) * (p.x() - 5.0)));
    positions.push_back(onWire ? bent : Point2(5.0 + std::sin(17.0 * v), 5.0 + std::cos(31.0 * v)));
  }
  return positions;
}
}

TEST(Untangling, ScatteredInteriorsInsideASimpleLoopEndWithoutFlips)
{
  for (double notch : { 0.0, 1.5 })
  {
    const Surface surface = flatPatch(10, 10);
    const WiredSurface wired(surface);
    Points2 positions = tangledPositions(wired, surface.unrolled, notch);
    ASSERT_GT(countFlipped(wired.piece.mesh, positions), 20);
    const Points2 before = positions;
    const UntanglingResult result = untangleInterior(wired.piece, wired.network, {}, positions);
    EXPECT_TRUE(result.status.ok());
    EXPECT_EQ(result.patches, (Indices{ 0 }));
    EXPECT_TRUE(result.tangled.empty());
    EXPECT_EQ(countFlipped(wired.piece.mesh, positions), 0);
    for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
    {
      if (wired.network.hostOfVertex[v] != none)
      {
        EXPECT_EQ(positions[v], before[v]);
      }
    }
  }
}

TEST(Untangling, LeavesPatchesWithoutFlipsAsTheyAre)
{
  const Surface surface = flatPatch(6, 6);
  const WiredSurface wired(surface);
  Points2 positions = unrolled(wired, surface);
  const Points2 before = positions;
  EXPECT_TRUE(untangleInterior(wired.piece, wired.network, {}, positions).patches.empty());
  EXPECT_EQ(positions, before);
}

TEST(Untangling, SaysWhichPatchCannotBeHelped)
{
  // The boundary runs clockwise: every triangle must be flipped.
  const Surface surface = flatPatch(4, 4);
  const WiredSurface wired(surface);
  Points2 positions = unrolled(wired, surface);
  for (Point2& p : positions)
  {
    p.x() = -p.x();
  }
  const UntanglingResult result = untangleInterior(wired.piece, wired.network, {}, positions);
  EXPECT_EQ(result.tangled, (Indices{ 0 }));
  for (const Point2& p : positions)
  {
    EXPECT_TRUE(p.allFinite());
  }
}

TEST(Untangling, MovesWhatLiesAroundFoldsAloneWhereThatIsAskedFor)
{
  const Surface surface = flatPatch(30, 30);
  const WiredSurface wired(surface);
  Points2 positions = unrolled(wired, surface);
  positions[wired.vertex(15 * 31 + 15)] += Point2(2.5, 0.3);
  ASSERT_GT(countFlipped(wired.piece.mesh, positions), 0);
  const Points2 before = positions;
  UntanglingOptions options;
  options.nearby = true;
  const UntanglingResult result =
    untangleInterior(wired.piece, wired.network, {}, positions, options);
  EXPECT_TRUE(result.tangled.empty());
  EXPECT_EQ(countFlipped(wired.piece.mesh, positions), 0);
  for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
  {
    if ((before[v] - Point2(15.0, 15.0)).norm() > 13.0)
    {
      EXPECT_EQ(positions[v], before[v]);
    }
  }
}
