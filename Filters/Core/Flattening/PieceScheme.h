// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PieceSolution.h"

namespace flattening
{
/// Flattens a piece, as its cuts are, by the scheme of the options. Keys that clash are released.
PieceSolution flattenByScheme(const PieceContext& context, const CurveRules& rules);

/// The same for a piece whose wires are solved and placed.
void finishScheme(const PieceContext& context, PieceSolution& piece);
}
