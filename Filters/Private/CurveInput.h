// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/FeatureCurve.h"

#include "vtkType.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// Feature curves of one or several data sets; the arrays are those of vtkFeatureCurveAlgorithm.
struct CurveInput
{
  std::vector<Polyline> polylines;       ///< pointIds: of the data set that holds the curve
  std::vector<vtkIdType> cellOfPolyline; ///< its first cell there
  std::vector<vtkPolyData*> dataOfPolyline;
  Status outcome;
  vtkPolyData* blamed = nullptr; ///< where the outcome is not Ok
};

/// Adds the line cells of a data set, but ghost cells. \return whether all of them are sound
bool readCurves(vtkPolyData* data, CurveInput& curves);
}
}
