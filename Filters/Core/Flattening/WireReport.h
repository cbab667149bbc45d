// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningResult.h"
#include "Wires/WireNetwork.h"

namespace flattening
{
/// Wires of a cut surface as polylines, without flat lengths: each feature curve in the stretches
/// and copies that the cuts leave of it, in the curve's order, then what of the boundary is no
/// curve.
std::vector<Wire> traceWires(
  const TriangleMesh& original, const CutSurface& cut, const std::vector<FeatureCurve>& curves);

/// Wires that are closed in the plane, in part or wholly, do not bound their piece. \param
/// closedEdges half-edges of the cut surface in ascending order
void noteClosedEdges(const TriangleMesh& cut, const Indices& closedEdges, std::vector<Wire>& wires);

/// The connectors of a piece as polylines.
std::vector<Wire> traceConnectors(const WireNetwork& network, const Piece& piece, Index pieceId);

/// Fills in the lengths of a wire from its vertices. \param positions of the cut surface's
/// vertices.
void measureWire(const CutSurface& cut, const Points2& positions, Wire& wire);

/// Fills in the length of the cuts that bound or slit each piece, each cut once a piece.
/// \pre closedEdges of the pieces are in ascending order
void measureCuts(const CutSurface& cut, std::vector<PieceReport>& pieces);

/// One row a curve, from its measured wires; of a curve that was cut the mean of its two sides.
/// What runs on pieces that are left out does not count.
std::vector<CurveReport> summarizeCurves(const TriangleMesh& original, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const std::vector<Wire>& wires);
}
