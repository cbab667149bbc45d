// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningCache.h"
#include "Flattening/PieceSolution.h"

namespace flattening
{
/// What is the same for all pieces of a surface.
struct PieceSettings
{
  const CutSurface& cut;
  const std::vector<FeatureCurve>& curves;
  const FlatteningOptions& options;
  bool keep = false; ///< the factors of the interior stay with the piece
};

/// Flattens one piece by the scheme of the options: network, angles, layout, interior, and again
/// with keys released, darts folding or cuts closed where that is asked for. Of the solution the
/// positions, the network of joined cuts, the seconds and the report remain, which lacks only
/// quality and overlaps; ids of its status are those of the cut surface.
PieceSolution flattenPiece(WiredPiece& wired, const PieceSettings& settings,
  const CurveRules& rules, const Execution& execution);

/// The network of a flat piece's wires: that of its joined cuts where some were.
inline const WireNetwork& networkOf(const WiredPiece& wired, const PieceSolution& flat)
{
  return flat.joinedNetwork ? *flat.joinedNetwork : *wired.network;
}
}
