// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/CurvedSurface.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// Adds the line cells of a data set, but ghost cells; the arrays are those of
/// vtkFeatureCurveAlgorithm. The outcome says whether all of them are sound.
void readCurves(vtkPolyData* data, int source, CurveInput& curves);
}
}
