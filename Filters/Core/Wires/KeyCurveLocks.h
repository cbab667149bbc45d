// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"
#include "Wires/WireNetwork.h"

#include <algorithm>
#include <optional>

namespace flattening
{
/// A vertex between mouth and tip on one side of a dart.
struct DartSideVertex
{
  Index curve = none;
  Index place = none;  ///< in the curve's vertices
  bool onLeft = false; ///< the cloth is on the left of the curve
  Index host = none;   ///< in WireNetwork::hostVertices
  Index before = none; ///< piece vertices beside it on the side, the cloth on the left of the way
  Index after = none;
  Indices nodes; ///< whose angles make up the cloth's
};

/// All vertices inside the open darts whose sides lie in a piece. None where more than the dart's
/// two sides meet, or where they are joined.
std::vector<DartSideVertex> findDartSides(const WireNetwork& network, const Piece& piece,
  const CutSurface& cut, const std::vector<FeatureCurve>& curves);

/// What a run decides of the feature curves beyond what was asked for. The curves themselves stay
/// as they came in.
struct CurveRules
{
  Indices released; ///< key curves whose planar shape is given up, ascending
  /// By curve the common stretch of an elastic curve that lies in several pieces: every edge gets
  /// its length times 1 + this. Empty where none is decided.
  std::vector<std::optional<double>> stretch;
  /// By curve, of darts whose legs are to be mirror images of each other: by vertex the angle by
  /// which either leg turns to the side of its cloth. Empty where none is.
  std::vector<std::vector<double>> legTurns;
  /// The boundary and the sides of cuts are no wires: see holdsLength().
  bool freeBoundary = false;
  /// How far lengths of the boundary beside all curves may go from those on the surface, as a
  /// fraction; 0 is rigid.
  double boundaryTolerance = 0.0;

  bool releases(Index curve) const
  {
    return std::binary_search(this->released.begin(), this->released.end(), curve);
  }
  std::optional<double> decidedStretch(Index curve) const
  {
    return this->stretch.empty() ? std::nullopt : this->stretch[curve];
  }
};

/// Whether the length of a curve, or of the boundary beside all curves (none), is kept: where the
/// boundary is free only that of accessory and key curves.
inline bool holdsLength(Index curve, const std::vector<FeatureCurve>& curves, bool freeBoundary)
{
  return !freeBoundary || (curve != none && !curves[curve].opens());
}

/// The same for an edge; those of connectors are not kept.
inline bool holdsLength(
  const WireEdge& edge, const std::vector<FeatureCurve>& curves, bool freeBoundary)
{
  return !edge.connector && holdsLength(edge.curve, curves, freeBoundary);
}

/// Whether a curve, or the boundary beside all curves (none), may change its length.
inline bool isElastic(
  Index curve, const std::vector<FeatureCurve>& curves, double boundaryTolerance)
{
  return (curve == none ? boundaryTolerance : curves[curve].tolerance) > 0.0;
}

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
