// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <algorithm>
#include <optional>

namespace flattening
{
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

  bool releases(Index curve) const
  {
    return std::binary_search(this->released.begin(), this->released.end(), curve);
  }
  std::optional<double> decidedStretch(Index curve) const
  {
    return this->stretch.empty() ? std::nullopt : this->stretch[curve];
  }
};
}
