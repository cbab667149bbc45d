// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Editing/DrawingSurface.h"

namespace flattening
{
/// Curves that follow from others, or from a stroke, with few nodes.
struct DerivedCurves
{
  std::vector<EditedCurve> curves;
  Status status;
};

/// The curve at a distance from another, with its traits: smooth where that one is, else straight
/// from node to node, and in both cases within 3 thousandths of the distance of what offsetPath()
/// draws. \param distance positive: on the left. Errors: as of offsetPath().
DerivedCurves offsetCurves(
  const DrawingSurface& surface, const EditedCurve& curve, double distance);

/// A closed curve pulled tight in its class, as straightLoop() has it, with its traits: straight
/// from node to node. Errors: InvalidOption (it is open); those of straightLoop().
DerivedCurves tightCurve(const DrawingSurface& surface, const EditedCurve& curve);

/// A curve within a distance, the tolerance, of the straight paths from point to point of a stroke;
/// closed where the stroke ends within three times the tolerance of where it starts.
/// \param kind Spline: smooth, else straight from node to node
/// Errors: InvalidOption (the tolerance is not above 0); CurveTooShort (the stroke is not
/// longer than the tolerance); those of fitSpline().
DerivedCurves strokeCurve(const DrawingSurface& surface, const std::vector<SurfacePoint>& stroke,
  double tolerance, SegmentKind kind = SegmentKind::Spline);
}
