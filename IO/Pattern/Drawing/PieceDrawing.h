// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/BorderMarks.h"
#include "Drawing/NamedFolds.h"

namespace flattening::pattern
{
/// Draws one piece: its lines, notches, drill holes, grainline and texts.
/// \param marks of all pieces
/// \param fold where there is one: half of the piece alone, or the piece with an edge on it
Status drawPiece(const DrawingSource& all, std::size_t piece, const std::vector<BorderMark>& marks,
  const std::optional<NamedFold>& fold, PatternPiece& drawing);
}
