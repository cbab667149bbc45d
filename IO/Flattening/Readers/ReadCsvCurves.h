// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <string>

namespace wirewarp
{
/// Reads feature curves from a table of points, a point a row: columns `name`, `x`, `y`, `z` and,
/// where it stands, `type` (accessory, key, straight, dart, seam or edge), in any order and letters
/// of any case, named by the first row and divided by comma, semicolon or tab. Fields in double
/// quotes may hold dividers. Rows of one name and type that follow each other are a curve; an empty
/// type is that of the row above where the name is the same. Without a type the name may begin with
/// it (see CurveList.h). Coordinates are those of the surface. The points of an edge lie
/// on the boundary, which it follows the shorter way from the vertex next to each to the next.
/// Throws InputError with file and line.
DataSet readCsvCurves(const std::string& path, const DataSet& surface);
}
