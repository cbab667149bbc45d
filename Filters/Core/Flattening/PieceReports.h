// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PieceSolution.h"

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

/// Completes the report of a piece with what is known before its quality is measured, measured on
/// its positions.
void reportPiece(const PieceContext& context, PieceSolution& solution);

/// Completes the status of a piece of a result whose pieces, wires and positions are measured: the
/// worst (see severity()) of LengthError (ids: curves, or edges where none is a curve's), what the
/// stages said, FlippedTriangles or Overlap (ids: triangles), and with it MissingGrain and
/// BeyondLimits (ids: triangles, the one farthest out first). Each status has a remedy.
void judgePiece(const CutSurface& cut, const std::vector<FeatureCurve>& curves,
  const FlatteningOptions& options, Index piece, FlatteningResult& result);
}
