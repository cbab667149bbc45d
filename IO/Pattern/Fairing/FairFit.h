// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Fairing/FairPlan.h"
#include "Fairing/OutlineMirror.h"

#include <optional>

namespace flattening::pattern
{
/// A stretch that stays as it was.
struct LeftStretch
{
  std::size_t chain = 0;
  std::size_t firstPoint = 0;
  double needed = 0.0;    ///< deviation with as many splines as make sense, millimetres
  double tolerance = 0.0; ///< that it had
};

/// Splines of exact lengths for all planned stretches.
struct FairFit
{
  std::vector<PlannedChain> start; ///< the plan that the search began with
  std::vector<PlannedChain> plan;
  std::vector<std::vector<FairSpan>> spans; ///< of each chain, along it
  std::vector<LeftStretch> left;

  // By piece.
  std::vector<bool> solved;           ///< false: nothing could be drawn otherwise
  std::vector<OutlineMirror> mirrors; ///< how the outline is drawn as its own mirror image
  /// What cannot be drawn so, which has ended the search for the curves of the piece.
  std::vector<std::optional<LeftStretch>> unmirrored;
  std::vector<double> deviation; ///< of its points, at most, millimetres
};

/// Of few curves: divided where the tolerance is not kept, then joined wherever it is kept without
/// a break. A stretch that cannot keep it stays edge by edge.
/// \param before what was found with other limits: pieces whose search would begin alike are taken
/// from it
FairFit fitFairBorders(const DrawingSource& all, const BorderChains& chains,
  const FairLimits& limits, const FairFit& before, const Execution& execution);
}
