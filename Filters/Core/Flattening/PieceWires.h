// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Angles/AngleSolver.h"
#include "Flattening/PieceContext.h"

namespace flattening
{
/// The wires' problem and its solution.
struct WireSolution
{
  CurveRules rules; ///< with which it was posed
  AngleProblem problem;
  AngleSolution angles;
  Indices warpingOrder;  ///< wire-patches, where they are warped progressively
  bool repaired = false; ///< progressive angles did not close, the nearest that do were taken

  /// Whether key curves hold an angle: there is something to release.
  bool locks() const { return this->problem.locks.lockedCount > 0; }
};

/// Solves the planar angles of one piece's wires by the scheme of the options, patch by patch or
/// all together, from a conformal map where the plain start ends badly. Shapes of key curves that
/// fold a wire over are IncompatibleKeys.
WireSolution solveWires(const PieceContext& context, const CurveRules& rules);
}
