// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningResult.h"

#include <gtest/gtest.h>

namespace testmeshes
{
/// All that a caller sees of two results is the same, bit for bit.
inline void expectSame(
  const flattening::FlatteningResult& result, const flattening::FlatteningResult& expected)
{
  EXPECT_EQ(result.status.code, expected.status.code) << result.status.message;
  EXPECT_EQ(result.status.ids, expected.status.ids);
  EXPECT_TRUE(result.cut->mesh.identical(expected.cut->mesh));
  EXPECT_EQ(result.cut->pieceOfTriangle, expected.cut->pieceOfTriangle);
  EXPECT_EQ(result.cut->curveOfHalfedge, expected.cut->curveOfHalfedge);
  EXPECT_EQ(result.cut->seamPairs.size(), expected.cut->seamPairs.size());
  EXPECT_EQ(result.positions, expected.positions);
  EXPECT_EQ(result.patchOfTriangle, expected.patchOfTriangle);
  EXPECT_EQ(result.developability, expected.developability);
  ASSERT_EQ(result.wires.size(), expected.wires.size());
  for (std::size_t w = 0; w < expected.wires.size(); ++w)
  {
    EXPECT_EQ(result.wires[w].type, expected.wires[w].type);
    EXPECT_EQ(result.wires[w].vertices, expected.wires[w].vertices);
    EXPECT_EQ(result.wires[w].curve, expected.wires[w].curve);
    EXPECT_EQ(result.wires[w].piece, expected.wires[w].piece);
    EXPECT_EQ(result.wires[w].restLength, expected.wires[w].restLength);
    EXPECT_EQ(result.wires[w].flatLength, expected.wires[w].flatLength);
  }
  ASSERT_EQ(result.pieces.size(), expected.pieces.size());
  for (std::size_t p = 0; p < expected.pieces.size(); ++p)
  {
    const flattening::PieceReport& piece = result.pieces[p];
    const flattening::PieceReport& other = expected.pieces[p];
    EXPECT_EQ(piece.quality.angleError, other.quality.angleError);
    EXPECT_EQ(piece.quality.globalHomogeneity, other.quality.globalHomogeneity);
    EXPECT_EQ(piece.quality.areaError, other.quality.areaError);
    EXPECT_EQ(piece.overlaps.listed, other.overlaps.listed);
    EXPECT_EQ(piece.area.loss, other.area.loss);
    EXPECT_EQ(piece.area.lossAfterCut, other.area.lossAfterCut);
    EXPECT_EQ(piece.area.cut, other.area.cut);
  }
  ASSERT_EQ(result.curves.size(), expected.curves.size());
  for (std::size_t c = 0; c < expected.curves.size(); ++c)
  {
    EXPECT_EQ(result.curves[c].restLength, expected.curves[c].restLength);
    EXPECT_EQ(result.curves[c].flatLength, expected.curves[c].flatLength);
    EXPECT_EQ(result.curves[c].error, expected.curves[c].error);
  }
}
}
