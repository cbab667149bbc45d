// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

namespace flattening
{
/// 1 where a, b, c turn anti-clockwise, -1 where clockwise, 0 where they are collinear: the sign
/// that exact arithmetic gives (J. R. Shewchuk, "Adaptive precision floating-point arithmetic and
/// fast robust geometric predicates", Discrete & Computational Geometry 18, 1997). Exact as long as
/// products of coordinates neither overflow nor underflow.
int orientation(const Point2& a, const Point2& b, const Point2& c);

/// Whether two closed segments have a point in common, by exact orientations.
bool segmentsMeet(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// The corners of the convex hull, anti-clockwise from the first by x, as indices, by exact
/// orientations (A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions",
/// Information Processing Letters 9, 1979).
Indices convexHull(const Points2& points);
}
