// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/CutEnds.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr Index columns = 6;

/// Vertex (i, j) of a flat patch of 6 x 6 squares.
Index at(Index i, Index j)
{
  return j * (columns + 1) + i;
}

std::vector<ShortEnd> ends(const std::vector<FeatureCurve>& curves)
{
  return endsShortOfBoundary(flatPatch(columns, 6).mesh, curves);
}

void expectEnd(const ShortEnd& end, Index curve, Index vertex, Index boundary)
{
  EXPECT_EQ(end.curve, curve);
  EXPECT_EQ(end.vertex, vertex);
  EXPECT_EQ(end.boundary, boundary);
}
}

TEST(CutEnds, NamesTheVertexThatContinuesADart)
{
  const std::vector<ShortEnd> found =
    ends({ curveOf(CurveType::Dart, "d", { at(3, 1), at(3, 2), at(3, 3) }) });
  ASSERT_EQ(found.size(), 1U);
  expectEnd(found[0], 0, at(3, 1), at(3, 0));
}

TEST(CutEnds, FindsTheEndOfADartThatWasDrawnFromItsTip)
{
  const std::vector<ShortEnd> found =
    ends({ curveOf(CurveType::Accessory, "a", { at(0, 3), at(1, 3) }),
      curveOf(CurveType::Dart, "d", { at(3, 3), at(4, 3), at(5, 3) }) });
  ASSERT_EQ(found.size(), 1U);
  expectEnd(found[0], 1, at(5, 3), at(6, 3));
}

TEST(CutEnds, NamesBothEndsOfASeam)
{
  const std::vector<ShortEnd> found =
    ends({ curveOf(CurveType::Seam, "s", { at(3, 1), at(3, 2), at(3, 3), at(3, 4), at(3, 5) }) });
  ASSERT_EQ(found.size(), 2U);
  expectEnd(found[0], 0, at(3, 1), at(3, 0));
  expectEnd(found[1], 0, at(3, 5), at(3, 6));
}

TEST(CutEnds, NamesOneEndOfAShortDart)
{
  FeatureCurve dart = curveOf(CurveType::Dart, "d", { at(3, 1), at(3, 2), at(3, 3), at(3, 4) });
  dart.vertices.push_back(at(3, 5));
  EXPECT_EQ(ends({ dart }).size(), 1U) << "the other is its tip";
}

TEST(CutEnds, TakesWhatReachesTheBoundaryOrAnotherCut)
{
  EXPECT_TRUE(ends({ curveOf(CurveType::Dart, "d", { at(3, 0), at(3, 1) }) }).empty())
    << "the tip of a short dart";
  EXPECT_TRUE(ends({ curveOf(CurveType::Seam, "s", { at(3, 0), at(3, 1), at(3, 2) }),
                     curveOf(CurveType::Dart, "d", { at(3, 1), at(2, 1) }) })
                .empty())
    << "a dart from a seam";
  EXPECT_TRUE(ends({ curveOf(CurveType::Key, "k", { at(3, 1), at(3, 2), at(3, 3) }) }).empty())
    << "a curve that cuts nothing";
}

TEST(CutEnds, TakesADartFarFromTheBoundary)
{
  EXPECT_TRUE(ends({ curveOf(CurveType::Dart, "eye", { at(3, 2), at(3, 3), at(3, 4) }) }).empty());
  EXPECT_TRUE(
    ends({ curveOf(CurveType::Seam, "ring", { at(1, 1), at(2, 1), at(2, 2), at(1, 2), at(1, 1) }) })
      .empty())
    << "a closed seam has no end";
}
