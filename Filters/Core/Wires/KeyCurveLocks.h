// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Wires/CurveRules.h"
#include "Wires/WireNetwork.h"

namespace flattening
{
/// A wire-node's angle where a key curve prescribes it.
struct NodeLocks
{
  std::vector<char> locked;
  std::vector<double> angle;
  Index lockedCount = 0;
};

/// No node is locked.
NodeLocks freeNodes(const WireNetwork& network);

/// Angles of the nodes on key curves: Eq. 1, or the curve's own planar shape, which divides the
/// angle on each side of the curve in proportion to the angles on the surface; and of those on the
/// legs of darts that are to be mirror images.
/// \param piece the piece of the network; \param cut the surface it comes from; \param rules name
/// the key curves that are released and how legs of darts turn.
NodeLocks lockKeyCurves(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const CurveRules& rules = {});

/// Key curves that have an edge in the network or prescribe an angle there, ascending.
Indices keyCurves(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves);
}
