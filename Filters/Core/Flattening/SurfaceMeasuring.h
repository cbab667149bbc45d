// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningCache.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"
#include "Flattening/PieceFlattening.h"

namespace flattening
{
/// Measures a result whose positions and wires are in place: triangles, developability, wires,
/// curves and pieces, whose reports it takes out of the flat pieces and judges. The status becomes
/// that of the worst piece. Measures of the surface stay with the pieces.
void measureResult(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, const Execution& execution, std::vector<WiredPiece>& pieces,
  std::vector<PieceSolution>& flat, FlatteningResult& result);
}
