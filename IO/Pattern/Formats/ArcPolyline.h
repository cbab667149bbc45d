// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <vector>

namespace flattening::pattern
{
/// Of arcs from what is drawn otherwise, millimetres: less than cutting machines miss.
constexpr double arcTolerance = 0.03;

/// A vertex of a polyline with arcs, as DXF has them.
struct ArcVertex
{
  Point2 at = Point2::Zero();
  /// Of the arc to the next vertex: the tangent of a quarter of its angle, above 0 where it turns
  /// to the left; 0: a straight line.
  double bulge = 0.0;
};

/// A line by as few arcs and straight lines as a greedy search finds, none of whose points is
/// farther from them than the tolerance. Ends of an open line are kept, and of a closed one its
/// sharpest corner, at which the vertices then begin.
std::vector<ArcVertex> arcPolyline(const Points2& line, bool closed, double tolerance);
}
