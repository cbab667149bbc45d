// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SurfaceFlattening.h"
#include "WireNetwork.h"

namespace flattening
{
/// One piece in the plane.
struct FlatPiece
{
  WireNetwork network;
  Points2 positions; ///< per piece vertex
  PieceReport
    report; ///< all but quality and overlaps; ids of the status are those of the cut surface
  double secondsWires = 0.0;
  double secondsInterior = 0.0;
};

/// Flattens one piece by the scheme of the options: network, angles, layout, interior. \param kept
/// factors of the interior from a run before and for the next one; may be null.
FlatPiece flattenPiece(const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
  const Execution& execution, InteriorSystems* kept);
}
