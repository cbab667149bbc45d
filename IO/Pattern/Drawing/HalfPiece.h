// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/MirrorPairs.h"
#include "Outlines/Pattern.h"

#include <vector>

namespace flattening::pattern
{
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
