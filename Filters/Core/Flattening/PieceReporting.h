// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningResult.h"
#include "Flattening/PieceScheme.h"

namespace flattening
{
/// What the wires are in the plane, whatever put them there.
struct WireMeasures
{
  double objective = 0.0; ///< of Eq. 13
  double closure = 0.0;   ///< largest of a loop, in the unit of length
};

/// Angles are those between the given positions, lengths those on the surface; of elastic curves
/// and connectors, whose lengths are free, those in the plane.
WireMeasures measureWires(const AngleProblem& problem, const Points2& positions);

/// What is known of a flat piece before its quality is measured, measured on its positions.
PieceReport reportPiece(const PieceContext& context, const FlatWires& flat);
}
