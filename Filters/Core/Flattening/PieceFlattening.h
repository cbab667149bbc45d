// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningCache.h"
#include "Flattening/FlatteningResult.h"
#include "Flattening/PieceContext.h"

namespace flattening
{
/// One piece in the plane.
struct FlatPiece
{
  Points2 positions; ///< per piece vertex
  /// Of the piece with banks of cuts joined, where they are; its edges end at vertices of the
  /// piece.
  std::optional<WireNetwork> joinedNetwork;
  PieceReport
    report; ///< all but quality and overlaps; ids of the status are those of the cut surface
  double secondsWires = 0.0;
  double secondsInterior = 0.0;
};

/// The network of a flat piece's wires: that of its joined banks where some were.
inline const WireNetwork& networkOf(const WiredPiece& wired, const FlatPiece& flat)
{
  return flat.joinedNetwork ? *flat.joinedNetwork : *wired.network;
}

/// What is the same for all pieces of a surface.
struct PieceSettings
{
  const CutSurface& cut;
  const std::vector<FeatureCurve>& curves;
  const FlatteningOptions& options;
  const CurveRules& rules;
  bool keep = false; ///< the factors of the interior stay with the piece
};

/// Flattens one piece by the scheme of the options: network, angles, layout, interior, and again
/// with keys released or cuts closed where that is asked for.
FlatPiece flattenPiece(
  WiredPiece& wired, const PieceSettings& settings, const Execution& execution);
}
