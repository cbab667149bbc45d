// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Editing/DrawingSurface.h"
#include "Paths/PathSearch.h"

#include <memory>

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

/// Segments as drawSegment() has them, without hints, for a mouse that moves: while they start in
/// the same place, each goes on with the search of those before.
class SegmentPreview
{
public:
  explicit SegmentPreview(std::shared_ptr<const DrawingSurface> surface);

  /// Errors: those of drawSegment().
  DrawnSegment draw(SegmentKind kind, const SurfacePoint& from, const SurfacePoint& to);

private:
  std::shared_ptr<const DrawingSurface> Surface;
  std::unique_ptr<PathSearch> Search;
};

/// Where the image of a point lies on the surface. That of a point on the boundary lies on it as
/// well, that of a point on a mirrored curve on the curve's image, where these are within a
/// twentieth of the surface's size: surfaces of bodies and their scans are nearly symmetric, and
/// cuts would end short of it. \param curves those that there are; their mirror is the plane
/// \param own of them the one that the point is a node of, or null
SurfacePoint imageOf(const DrawingSurface& surface, const CurveSet& curves, const EditedCurve* own,
  const SurfacePoint& point);

/// Draws the curve's segments, and its image where there is a plane, beside the curves that there
/// are, with their mirror. The segments that it holds,
/// where they are as many as it has, are hints, but for empty ones. What is as in the curve before
/// is taken over. \param before may be null. Errors: as above.
Status drawCurve(const DrawingSurface& surface, const CurveSet& curves, const EditedCurve* before,
  EditedCurve& curve);
}
