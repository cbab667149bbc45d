// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawingSource.h"

namespace flattening
{
namespace pattern
{
/// Draws one piece: its lines, notches, drill holes, grainline and texts.
PatternStatus drawPiece(const DrawingSource& all, std::size_t piece, PatternPiece& drawing);
}
}
