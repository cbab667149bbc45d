// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "AngleSolver.h"

#include <functional>

namespace flattening
{
struct KeyRelease
{
  AngleSolution solution; ///< with the suggested curves released
  Indices released;       ///< curves
  NodeLocks locks;        ///< of the other key curves
  /// IncompatibleKeys with the names of all key curves concerned and of those to release (ids:
  /// curves); the failed solution's own status where releasing all keys does not help.
  Status status;
};

/// Finds the least set of key curves whose release makes the others compatible: each one alone,
/// then pairs, up to all; among sets of one size the one with the least objective.
/// \param failed the solution with all keys; \param solve solves for given locks.
KeyRelease releaseKeys(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const AngleSolution& failed,
  const std::function<AngleSolution(const NodeLocks&)>& solve);
}
