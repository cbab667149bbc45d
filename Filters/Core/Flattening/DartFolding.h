// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PieceScheme.h"

namespace flattening
{
/// A piece flattened so that its darts fold.
struct FoldedWires
{
  FlatWires flat;
  Indices free; ///< darts whose legs stay free although others were asked for, ascending
};

/// Flattens a piece by the scheme of the options, first with free legs, then with those of
/// FlatteningOptions::dartLegs. A dart whose legs cannot be so (it branches, keys would have to be
/// released, triangles would fold over, there is no solution) keeps free ones.
FoldedWires flattenWithFoldingDarts(const PieceContext& context, const CurveRules& rules);
}
