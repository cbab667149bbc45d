// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/PieceArrangement.h"

#include "WiredSurface.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
using Box = Eigen::AlignedBox2d;

Box boundsOf(const Points2& points)
{
  Box box;
  for (const Point2& p : points)
  {
    box.extend(p);
  }
  return box;
}

Points2 turnedAndMoved(const Points2& points, double angle, const Point2& shift)
{
  Points2 result;
  for (const Point2& p : points)
  {
    result.push_back(Eigen::Rotation2Dd(angle) * p + shift);
  }
  return result;
}

/// Pieces of different sizes and shapes, some with a grain.
std::vector<ArrangementPiece> severalPieces()
{
  std::vector<ArrangementPiece> pieces;
  for (Index k = 0; k < 7; ++k)
  {
    ArrangementPiece piece;
    const Surface surface = k % 2 == 0 ? cone(6 + k, 4) : flatPatch(3 + k, 2);
    piece.positions = turnedAndMoved(surface.unrolled, 0.7 * k, Point2(3.0 * k, -2.0));
    if (k % 3 != 0)
    {
      piece.grain = { 1, static_cast<Index>(piece.positions.size()) - 2 };
    }
    pieces.push_back(piece);
  }
  return pieces;
}
}

TEST(PieceArrangement, MeasuresConvexHulls)
{
  EXPECT_EQ(hullArea({}), 0.0);
  EXPECT_EQ(hullArea({ { 1.0, 2.0 }, { 3.0, 4.0 } }), 0.0);
  // An L of three unit squares, whose hull closes the corner by half of one, wherever it is.
  const Points2 corners{ { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 }, { 1.0, 2.0 },
    { 0.0, 2.0 } };
  for (const Point2& move : { Point2(0.0, 0.0), Point2(-512.0, 1024.0) })
  {
    EXPECT_EQ(hullArea(turnedAndMoved(corners, 0.0, move)), 3.5);
  }
}

TEST(PieceArrangement, MovesPiecesRigidlyTurnsTheirGrainUpAndKeepsThemApart)
{
  const auto pieces = severalPieces();
  const auto placed = arrangePieces(pieces, 0.05);
  ASSERT_EQ(placed.size(), pieces.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    EXPECT_LT(rigidDistance(pieces[k].positions, placed[k]), 1e-13);
    largest = std::max(largest, boundsOf(placed[k]).sizes().maxCoeff());
    if (pieces[k].grain[0] != none)
    {
      const Point2 grain = placed[k][pieces[k].grain[1]] - placed[k][pieces[k].grain[0]];
      EXPECT_NEAR(grain.x(), 0.0, 1e-13);
      EXPECT_GT(grain.y(), 0.0);
    }
  }
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    for (std::size_t other = 0; other < k; ++other)
    {
      const double gap = boundsOf(placed[k]).exteriorDistance(boundsOf(placed[other]));
      EXPECT_GE(gap, 0.05 * largest * (1.0 - 1e-9)) << k << ' ' << other;
    }
  }
}

TEST(PieceArrangement, CopesWithNothingWithPointsAndWithAGrainOfNoLength)
{
  EXPECT_TRUE(arrangePieces({}, 0.05).empty());
  const Points2 points(4, Point2(1.0, 2.0));
  const auto placed = arrangePieces({ { {}, {} }, { points, { 0, 2 } }, { points, {} } }, 0.05);
  ASSERT_EQ(placed.size(), 3u);
  EXPECT_TRUE(placed[0].empty());
  EXPECT_EQ(placed[1][3], Point2(0.0, 0.0));
}
