// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

/// Pieces of the given extents.
inline flattening::pattern::PatternPiece rectangle(const flattening::Point2& extent)
{
  using namespace flattening::pattern;
  PatternPiece piece;
  piece.name = "rectangle";
  piece.extent = extent;
  PatternLine line;
  line.kind = LineKind::CutLine;
  line.closed = true;
  line.points = { { 0.0, 0.0 }, { extent.x(), 0.0 }, extent, { 0.0, extent.y() } };
  piece.lines.push_back(line);
  return piece;
}
