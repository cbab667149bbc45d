// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace wirewarp
{
/// Reads feature curves from the entities LINE, LWPOLYLINE and POLYLINE of an ASCII DXF file, all
/// releases; what else there is is passed over, and of bulges the chord is taken. The layer gives
/// type and name: "dart left", see CurveList.h. Coordinates are those of the surface. Throws
/// InputError.
vtkSmartPointer<vtkPolyData> readDxfCurves(const std::string& path);
}
