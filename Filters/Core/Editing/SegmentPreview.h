// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Editing/CurveDrawing.h"
#include "Paths/PathSearch.h"

#include <memory>

namespace flattening
{
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
}
