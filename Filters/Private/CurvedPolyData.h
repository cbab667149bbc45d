// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "AttributeArrays.h"
#include "Input/CurvedSurface.h"
#include "SurfaceInput.h"
#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <vector>

namespace flattening::bridge
{
/// What a surface was read from: the parts of a data set, which several data sets may share, and
/// its time, which is that of the part that was modified last.
class SurfaceOrigin
{
public:
  /// Nothing: no data is the same.
  SurfaceOrigin() = default;
  explicit SurfaceOrigin(vtkPolyData* data);

  /// Whether the data has the same parts, and none was modified in between.
  bool sameAs(const SurfaceOrigin& other) const;

private:
  vtkMTimeType Time = 0;
  vtkWeakPointer<vtkPoints> Points;
  std::array<vtkWeakPointer<vtkCellArray>, 4> Cells; ///< verts and lines count in cell ids
  vtkWeakPointer<vtkAbstractArray> Ghosts;
};

/// A surface with its feature curves as data sets hold them. The sources of the curves are the
/// surface itself, 0, and then the others.
struct CurvedPolyData : CurvedSurface
{
  /// Of this run only.
  std::vector<vtkPolyData*> sources;
  /// Arrays of the surface that have a value for each point or cell.
  vtkSmartPointer<vtkPointData> pointArrays;
  vtkSmartPointer<vtkCellData> cellArrays;
  vtkSmartPointer<vtkFieldData> fieldData;

  /// Of the data that `surface` was loaded from.
  SurfaceOrigin origin;
  CoincidentPoints coincident = CoincidentPoints::Automatic;
  Defects defects = Defects::Heal;
};

/// Adds the line cells of a data set, as readCurves() does. The outcome says whether they are
/// sound.
void readCurvesOf(vtkPolyData* data, int source, CurveInput& curves);

/// Loads the surface with its curves. What the source holds of a run before is taken over where it
/// is made from the same: the surface and, where the points of the curves are the same, the
/// imprint.
void loadCurvedSurface(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves,
  CoincidentPoints coincident, Defects defects, const ImprintOptions& options,
  const Execution& execution, CurvedPolyData& source);
}
