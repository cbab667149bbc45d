// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/BorderMarks.h"
#include "Drawing/PieceFold.h"

#include <optional>

namespace flattening::pattern
{
/// Draws one piece: its lines, notches, drill holes, grainline and texts.
/// \param image a piece that is not drawn since it is this one's mirror image
/// \param marks of all pieces
/// \param fold where there is one: half of the piece alone, or the piece with an edge on it
Status drawPiece(const DrawingSource& all, std::size_t piece, std::optional<std::size_t> image,
  const std::vector<BorderMark>& marks, const std::optional<PieceFold>& fold,
  PatternPiece& drawing);
}
