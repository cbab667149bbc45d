// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"
#include "Outlines/PlaneGeometry.h"

#include <vector>

namespace flattening::pattern
{
/// Adds the texts of a piece whose lines, notches and grainline are there: name, size, quantity and
/// count (PatternPiece::texts comes with these lines, unplaced) at the widest free place, the names
/// of the feature curves beside them.
/// \param boundary the sew lines as segments
/// \param joins whose marks are placed before the names: in the middle, and near both ends where there
/// is room
void placeTexts(const Segments& boundary, const std::vector<JoinSide>& joins, PatternPiece& piece);

/// Adds the names of seams, darts, feature curves and the grainline, each beside its line and,
/// where there is room, across no other line and no text. The piece's other texts are placed
/// already.
/// \param boundary the sew lines as segments
void placeCurveNames(const Segments& boundary, PatternPiece& piece);
}
