// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Editing/DrawingSurface.h"

namespace flattening
{
/// What a point may snap to.
enum class SnapTarget
{
  Nothing = 0,
  Boundary = 1,
  Corner = 2, ///< of the boundary
  Vertex = 3,
  Curve = 4,   ///< a node of another curve or a place on it
  DartTip = 5, ///< an end of a dart inside of the surface
  MirrorPlane = 6,
};

/// How far things are from each other to an eye: along its line of sight a tenth counts, since who
/// aims at the side of a surface misses by much in depth. Without a direction all count alike.
class SightMetric
{
public:
  SightMetric() = default;
  explicit SightMetric(const Point3& direction);

  double distance(const Point3& a, const Point3& b) const { return this->seen(a - b).norm(); }
  /// The fraction of the segment at its point nearest to another.
  double nearestFraction(const Point3& a, const Point3& b, const Point3& point) const;

private:
  Point3 seen(const Point3& difference) const;

  Point3 Direction = Point3::Zero(); ///< of length 1, or none
};

struct SnapOptions
{
  double reach = 0.0; ///< in space; 0: nothing snaps
  bool boundary = true;
  bool corner = true;
  bool vertex = true;
  bool curve = true;
  bool dartTip = true;
  bool mirrorPlane = true;
  Index exceptCurve = none; ///< whose node is being moved
  SightMetric sight;
};

struct SnappedPoint
{
  SurfacePoint point;
  SnapTarget target = SnapTarget::Nothing;
  Index curve = none; ///< the one snapped to
};

/// Moves a point of the surface onto what is within reach: first onto the nearest single point
/// (dart tip, node, corner), then onto the nearest line (boundary, curve, mirror plane), last onto
/// a vertex, where there is a line onto one of its own. Vertices draw from no farther than a third
/// of the edges there, so that there is room between them however near the eye is.
SnappedPoint snapPoint(const DrawingSurface& surface, const CurveSet& curves,
  const SurfacePoint& point, const SnapOptions& options);
}
