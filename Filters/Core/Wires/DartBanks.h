// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Wires/WireNetwork.h"

namespace flattening
{
/// A vertex between mouth and tip on one bank of a dart.
struct DartBankVertex
{
  Index curve = none;
  Index place = none;  ///< in the curve's vertices
  bool onLeft = false; ///< the cloth is on the left of the curve
  Index host = none;   ///< in WireNetwork::hostVertices
  Index before = none; ///< piece vertices beside it on the bank, the cloth on the left of the way
  Index after = none;
  Indices nodes; ///< whose angles make up the cloth's
};

/// All vertices inside the open darts whose banks lie in a piece. None where more than the dart's
/// two banks meet, or where they are joined.
std::vector<DartBankVertex> findDartBanks(const WireNetwork& network, const Piece& piece,
  const CutSurface& cut, const std::vector<FeatureCurve>& curves);

/// The wire-nodes at a vertex from the wire edge of a side that starts there, counter-clockwise, to
/// the wire edge towards another vertex; empty where the surface ends in between.
Indices nodesBetween(const WireNetwork& network, Index startSide, Index endVertex);
}
