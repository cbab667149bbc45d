// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/FeatureCurve.h"

#include <optional>

namespace flattening
{
/// A proposed cut or line. What is measured without it, or with it, is NaN where the surface cannot
/// be flattened so, as a closed one until it is cut.
struct SuggestedCurve
{
  Polyline curve;
  double length = 0.0;
  /// Drops of the mean of u^2 (see ScaleFactor) and of the rigid energy over the surface, by this
  /// cut after those before it; mirror images share one.
  double predictedGain = 0.0;
  double gain = 0.0;
  double opening = 0.0;         ///< of a dart's widest place, by the forecast
  double areaErrorBefore = 0.0; ///< mean change of area without it and those after it
  double areaErrorAfter = 0.0;
  double strainBefore = 0.0; ///< largest p95 strain of a piece without it and those after it
  double strainAfter = 0.0;
  bool sound = true; ///< of a line that is left out: it breaks no promise, but costs too much
  std::optional<Point3> via; ///< of a seam: where it runs over a peak; straight before and behind
  Index mirrorOf = none;     ///< the proposal that it is the mirror image of
};
}
