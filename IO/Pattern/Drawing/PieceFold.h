// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/DrawingSource.h"
#include "Outlines/MirrorPairs.h"

#include <optional>

namespace flattening::pattern
{
/// How a piece lies on the fold of the cloth.
struct PieceFold
{
  MirrorAxis axis;       ///< about which a half of the piece is drawn, or its edge on the fold
  bool isBorder = false; ///< the piece is a half
};

/// Along a curve that the options name, or where the piece is symmetric if they say so.
/// \param fold none where there is none
/// \return InvalidOption where the curve is sewn, bends by more than mirrorTolerance, is one of two,
/// or is not a line of symmetry of the piece, with both names
Status findFold(const DrawingSource& all, std::size_t piece, const std::string& pieceName,
  const PieceShape& shape, std::optional<PieceFold>& fold);

/// The part of a closed polygon on the right of an axis; what runs across is closed along the axis.
Points2 rightHalf(const Points2& polygon, const MirrorAxis& axis);

/// The fold from the lowest to the highest place of the cut line on the axis.
PatternLine foldLine(const std::vector<PatternLine>& lines, const MirrorAxis& axis);

/// Of the sides of joins of a symmetric piece what lies on the right of its axis. A side has the
/// marks of its mirror image as well, "A/B", since it is cut for both.
std::vector<JoinSide> rightHalf(const std::vector<JoinSide>& sides, const MirrorAxis& axis);

/// Leaves of a symmetric piece what lies on the right of its axis, and draws the fold there. Lines
/// that lie along the axis are drawn on it.
void keepRightHalf(const MirrorAxis& axis, PatternPiece& piece);
}
