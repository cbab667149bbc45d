// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Editing/DrawingSurface.h"
#include "Editing/EditedCurve.h"

#include <optional>
#include <vector>

namespace flattening
{
/// How curves run through control points.
struct CurveControl
{
  CurveTraits traits;
  SegmentKind kind = SegmentKind::Geodesic;
  bool closed = false;
  bool tight = false;  ///< pulled tight, as tightCurve() has it
  double offset = 0.0; ///< as offsetCurves() has it; 0: the curve itself
  std::optional<MirrorPlane> mirror;
};

/// The curves through the points of the surface that are closest to the control points of each
/// list, one after the other; their names get numbers where there are several. Several control
/// points in a row that mean the same point count once, and a list that ends where it starts is
/// closed.
///
/// Errors: NonFinitePoint; CurveTooShort (fewer than two different control points, or three of a
/// closed curve that is not a section); those of drawCurve(), tightCurve() and offsetCurves(). The
/// message names the curve where there are several, or it has a name.
Status drawControlledCurves(const DrawingSurface& surface, const std::vector<Points3>& controls,
  const CurveControl& control, std::vector<EditedCurve>& curves);
}
