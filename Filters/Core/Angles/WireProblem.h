// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"

namespace flattening
{
/// The angle problem of a piece's wires as every scheme, trial and piece of advice poses it: key
/// curves locked but for the released ones, elastic curves and connectors with their stretches.
AngleProblem makeWireProblem(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const CurveRules& rules = {});
}
