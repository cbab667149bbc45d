// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"
#include "Editing/CurveDrawing.h"
#include "Editing/CurveEditor.h"

#include <algorithm>
#include <cstddef>
#include <memory>

namespace flattening
{
namespace bridge
{
/// What is behind a vtkFeatureCurveEditor with a surface.
class CurveEditorModel
{
public:
  explicit CurveEditorModel(TriangleMesh mesh)
    : CurveEditorModel(std::make_shared<const DrawingSurface>(std::move(mesh)))
  {
  }

  /// Null where there is none.
  const EditedCurve* curve(int id) const
  {
    return id >= 0 && static_cast<std::size_t>(id) < this->editor.curveCount()
      ? &this->editor.curve(static_cast<std::size_t>(id))
      : nullptr;
  }

  CurveEditor editor;
  SegmentPreview preview;

private:
  explicit CurveEditorModel(const std::shared_ptr<const DrawingSurface>& surface)
    : editor(surface)
    , preview(surface)
  {
  }
};

inline Point3 pointOf(const double point[3])
{
  return { point[0], point[1], point[2] };
}

using flattening::isFinite;
inline bool isFinite(const double point[3])
{
  return flattening::isFinite(pointOf(point));
}

template <typename Value>
Value clampedKind(Value last, int kind)
{
  return static_cast<Value>(std::clamp(kind, 0, static_cast<int>(last)));
}

inline SegmentKind kindOf(int kind)
{
  return clampedKind(SegmentKind::Spline, kind);
}

/// An id of Core; one that does not exist stays so.
inline std::size_t idOf(int id)
{
  return static_cast<std::size_t>(id);
}
}
}
