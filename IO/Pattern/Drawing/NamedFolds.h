// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/DrawingSource.h"
#include "Outlines/MirrorPairs.h"

#include <optional>

namespace flattening::pattern
{
/// How a piece lies on the fold of the cloth.
struct NamedFold
{
  std::string curve;     ///< that the options name; empty where the axis was found
  bool isBorder = false; ///< the piece is a half, and this edge of its border lies on the fold
  MirrorAxis axis;       ///< otherwise one half of it is drawn
};

/// Along a curve that the options name. \param fold none where the piece has no such curve
/// \return InvalidOption where the curve is sewn, bends by more than mirrorTolerance, is one of two, or
/// is no line of symmetry of the piece, with both names
Status findNamedFold(const DrawingSource& all, std::size_t piece, const std::string& pieceName,
  const PieceShape& shape, std::optional<NamedFold>& fold);
}
