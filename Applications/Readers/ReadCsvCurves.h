// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace wirewarp
{
/// Reads feature curves from a table of points, a point a row: columns `name`, `x`, `y`, `z` and,
/// where it stands, `type` (accessory, key, dart or seam), in any order and letters of any case,
/// named by the first row and divided by comma, semicolon or tab. Rows of one name and type that
/// follow each other are a curve. Without a type the name may begin with it (see CurveList.h).
/// Coordinates are those of the surface. Throws InputError with file and line.
vtkSmartPointer<vtkPolyData> readCsvCurves(const std::string& path);
}
