// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/SegmentPreview.h"

#include "Base/Memory.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

namespace flattening
{
SegmentPreview::SegmentPreview(std::shared_ptr<const DrawingSurface> surface)
  : Surface(std::move(surface))
{
}

DrawnSegment SegmentPreview::draw(
  SegmentKind kind, const SurfacePoint& from, const SurfacePoint& to)
{
  if (kind == SegmentKind::Section || !liesOn(this->Surface->mesh(), from))
  {
    return drawSegment(*this->Surface, kind, from, to);
  }
  DrawnSegment result = withinMemory([&] {
    const PathArcs arcs = kind == SegmentKind::Edges ? PathArcs::Edges : PathArcs::All;
    if (!this->Search || this->Search->arcs() != arcs || !samePlace(this->Search->source(), from))
    {
      this->Search = std::make_unique<PathSearch>(this->Surface->graph(), from, arcs);
    }
    StraightPath straight =
      kind == SegmentKind::Edges ? pathByEdges(*this->Search, to) : straightPath(*this->Search, to);
    return DrawnSegment{ std::move(straight.path), std::move(straight.status) };
  });
  if (result.status.code == StatusCode::OutOfMemory)
  {
    this->Search.reset(); // it was left amid a step
  }
  return result;
}
}
