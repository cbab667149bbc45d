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
};

struct SnappedPoint
{
  SurfacePoint point;
  SnapTarget target = SnapTarget::Nothing;
  Index curve = none; ///< the one snapped to
};

/// Moves a point of the surface onto what is within reach: first onto the nearest single point
/// (dart tip, node, corner), then onto the nearest line (boundary, curve, mirror plane), last onto
/// a vertex. Vertices draw from no farther than a third of the edges there, so that there is room
/// between them however near the eye is.
SnappedPoint snapPoint(const DrawingSurface& surface, const CurveSet& curves,
  const SurfacePoint& point, const SnapOptions& options);
}
