// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Editing/DrawingSurface.h"

class vtkPolyData;

namespace flattening::bridge
{
/// The curves of two nodes or more, their images, and what makes them editable again, as
/// vtkFeatureCurveEditor documents.
void writeCurveSet(const CurveSet& set, vtkPolyData* data);

/// One curve as it is drawn: a cell a segment, then its image.
void writeCurve(const EditedCurve& curve, vtkPolyData* data);
void writePath(const SurfacePath& path, vtkPolyData* data);

/// What writeCurveSet() wrote, or any polylines near the surface.
struct CurveSetInput
{
  std::vector<EditedCurve> curves;
  std::optional<MirrorPlane> mirror;
  Status status;
  std::string note; ///< on the curve that lies farthest from the surface, where one is not on it
};
CurveSetInput readCurveSet(vtkPolyData* data, const DrawingSurface& surface);
}
