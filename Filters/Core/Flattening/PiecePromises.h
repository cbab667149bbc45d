// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"

namespace flattening
{
/// Completes the status of the last piece of a result whose pieces, wires and positions are
/// measured: of the promises that are broken the worst (see severity()), LengthError (ids: curves,
/// or edges where none is a curve's), what the stages have said, FlippedTriangles or Overlap (ids:
/// triangles), what the cloth cannot keep (see brokenClothPromises()). Each status has a way out.
void judgeLastPiece(const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, FlatteningResult& result);
}
