// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/FeatureCurve.h"
#include "Wires/KeyCurveLocks.h"
#include "Wires/WireNetwork.h"

namespace flattening
{
/// By curve; none where it is rigid or not in the piece.
using CurveStretches = std::vector<std::optional<double>>;

/// By how much the elastic curves are longer in a flat piece than on the surface, as fractions.
CurveStretches stretchesIn(
  const WireNetwork& network, const Points2& positions, const std::vector<FeatureCurve>& curves);

/// Each piece chooses the lengths of its elastic curves by itself, but what is sewn together must
/// be equally long: decides for the mean where a curve lies in several pieces.
/// \return what is decided, by curve; empty where all pieces agree
CurveStretches agreeOnStretches(const std::vector<CurveStretches>& pieces);
}
