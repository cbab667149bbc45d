// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolver.h"

#include <functional>

namespace flattening
{
/// Key curves with an edge in the network, ascending.
Indices keyCurves(const WireNetwork& network, const std::vector<FeatureCurve>& curves);

struct KeyRelease
{
  AngleSolution solution; ///< with the suggested curves released
  Indices released;       ///< curves
  NodeLocks locks;        ///< of the other key curves
  /// IncompatibleKeys with the names of the key curves that clash and of those to release (ids:
  /// curves); the failed solution's own status where releasing all keys does not help.
  Status status;
};

/// Finds the least set of key curves whose release makes the others compatible, among several the
/// one with the least objective (of 32 that are compared). Where that takes more than 100
/// solutions, as it does where many keys clash with each other: a set of which no curve can be
/// kept.
/// \param failed the solution with all keys; \param solve solves for given locks.
KeyRelease releaseKeys(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const AngleSolution& failed,
  const std::function<AngleSolution(const NodeLocks&)>& solve);
}
