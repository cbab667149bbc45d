// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/CutClosure.h"
#include "Flattened.h"

using namespace flattening;
using namespace testmeshes;

TEST(CutClosure, TakesTimeInProportionToTheLengthOfTheCut)
{
  // A slit along the middle of a strip, every other vertex of one side across the other.
  constexpr Index columns = 100000;
  constexpr Index rows = 4;
  Surface strip = unitSquares(columns, rows);
  Indices slit;
  for (Index i = 1; i <= columns; ++i)
  {
    slit.push_back(2 * (columns + 1) + i);
  }
  strip.curves = { curveOf(CurveType::Dart, "slit", slit) };
  const CutSurface cut = cutSurface(strip.mesh, strip.curves);
  const Piece piece = extractPieces(cut).front();
  Points2 positions;
  for (const Point3& p : piece.mesh.points())
  {
    positions.emplace_back(p.x(), p.y());
  }
  const Points2 open = positions;
  const std::vector<CutSides> sides = findCutSides(piece, cut);
  for (const auto& pair : sides.front().pairs)
  {
    Point2& first = positions[pair[0]];
    Point2& second = positions[pair[1]];
    const double across = static_cast<Index>(first.x()) % 2 == 0 ? 0.1 : -0.1;
    first.y() += across;
    second.y() -= across;
  }

  Indices joined;
  const double whole = secondsOf([&] {
    closeCuts(piece, cut, positions, [&](const Indices& first) {
      joined = first;
      return std::optional<Points2>(open);
    });
  });
  const double once = secondsOf([&] { joinVertices(piece, joined); });
  EXPECT_LT(whole, 30.0 * once);

  Index copies = 0;
  for (std::size_t v = 0; v < joined.size(); ++v)
  {
    copies += joined[v] == static_cast<Index>(v) ? 0 : 1;
  }
  EXPECT_GE(copies, columns / 2 - 1);
}
