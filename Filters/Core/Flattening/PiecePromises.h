// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"

namespace flattening
{
/// Adds the first broken promise to the report of a measured piece that has none yet: LengthError,
/// FlippedTriangles, Overlap (ids: triangles).
void judgePiece(const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, PieceReport& report);
}
