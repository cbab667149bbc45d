// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothMeasures.h"

namespace flattening
{
/// How a piece lies on its cloth, which has its warp along y.
struct GrainReport
{
  /// From the curve, or else from the upright of the piece (see ClothOptions), to the warp,
  /// counter-clockwise, in radians.
  double angle = 0.0;
  Index curve = none;
  /// The largest distance of that curve from the line between its ends, over its length.
  double bend = 0.0;
  bool missing = false; ///< none of the curves that were asked for lies in the piece
  Indices candidates;   ///< then those that could give it
};

struct ClothReport
{
  GrainReport grain;
  bool oneWay = false; ///< the material must not be turned by half a turn
  /// By how much the angle between the material's threads may change, in radians.
  double shearLimit = std::numeric_limits<double>::infinity();
  bool solved = false;  ///< the piece has the cloth's least energy; else it was only laid on it
  ClothSummary threads; ///< per triangle of the piece
  /// Where the limits are not met: triangles of the cut surface, the one farthest out first, and
  /// the wire that most of them lie along, which will not give way.
  Indices outOfLimit;
  Index limitingCurve = none;
  bool limitedByBoundary = false;
};
}
