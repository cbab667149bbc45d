// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Surface/FeatureCurve.h"
#include "Wires/KeyCurveLocks.h"

namespace flattening
{
/// By how much a curve is longer in one piece than on the surface; what it is sewn to is not.
struct CurveEase
{
  std::string curve;  ///< all curves of this name
  Index piece = none; ///< none: the only one that they are in
  double fraction = 0.0;
};

/// By curve its stretch (as in CurveRules); none where it is rigid or not in the piece.
using CurveStretches = std::vector<std::optional<double>>;
using PieceStretches = std::vector<CurveStretches>;

/// Decides stretches by piece: a curve that is eased in one piece has the length of the surface in
/// the others. Empty where there is no ease. Eases that curves have of their own hold where none is
/// given for their names.
/// Errors: InvalidOption where a curve is not there or not in the piece, would change by more than
/// its tolerance, or has both of its sides in the piece.
Status decideEases(const std::vector<CurveEase>& eases, const std::vector<FeatureCurve>& curves,
  const CutSurface& cut, const std::vector<const Piece*>& pieces, PieceStretches& stretches);
}
