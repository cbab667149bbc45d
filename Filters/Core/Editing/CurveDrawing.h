// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Editing/DrawingSurface.h"

namespace flattening
{
struct DrawnSegment
{
  SurfacePath path;
  Status status;
};

/// A segment between two nodes. \param hint where it ran before, so that it does not jump while a
/// node is dragged; may be null
///
/// Errors: CurveLeavesSurface (the nodes lie on different parts, or no section joins them);
/// InvalidPointId; OutOfMemory.
DrawnSegment drawSegment(const DrawingSurface& surface, SegmentKind kind, const SurfacePoint& from,
  const SurfacePoint& to, const SurfacePath* hint = nullptr);

/// Draws the curve's segments, and its image where there is a plane. The segments that it holds,
/// where they are as many as it has, are hints, but for empty ones. What is as in the curve before
/// is taken over. \param before may be null. Errors: as above.
Status drawCurve(const DrawingSurface& surface, const std::optional<MirrorPlane>& mirror,
  const EditedCurve* before, EditedCurve& curve);
}
