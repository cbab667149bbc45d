// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

namespace flattening::pattern
{
struct Segment
{
  Point2 from;
  Point2 to;
};
using Segments = std::vector<Segment>;

/// The sides of a polygon, or the segments of an open line.
void addSegments(const Points2& points, bool closed, Segments& segments);

/// Parameters s, in ascending order, at which from + s * direction meets the segments.
std::vector<double> crossings(
  const Point2& from, const Point2& direction, const Segments& segments);

double distance(const Point2& point, const Segments& segments);
/// The nearest point of the segments, of which there are some.
Point2 nearestPoint(const Point2& point, const Segments& segments);

/// Whether a segment enters an upright rectangle, its border included.
bool enters(const Point2& from, const Point2& to, const Point2& low, const Point2& high);

/// Even-odd rule.
bool inside(const Point2& point, const Segments& borders);

/// A point inside the borders, far from them and from the obstacles; the lower left corner of the
/// bounding box where the borders enclose nothing.
/// \param clearance its distance
Point2 widestPlace(const Segments& borders, const Segments& obstacles, double& clearance);

/// A closed polygon with fewer points, of which none that is left out is farther from it than a
/// distance (D. H. Douglas, T. K. Peucker, Cartographica 10(2), 1973).
Points2 thinned(const Points2& polygon, double distance);

/// The same with still fewer points on rounds, each as far from the one before as the distance
/// allows; sharp corners need not be among them.
Points2 simplified(const Points2& polygon, double distance);

using Box = Eigen::AlignedBox2d;

/// Around points.
Box boxOf(const Points2& points);
}
