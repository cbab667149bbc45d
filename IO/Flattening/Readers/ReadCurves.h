// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <string>

namespace wirewarp
{
/// Reads feature curves from .vtp or .vtk (polylines with the cell arrays `CurveType` and
/// `CurveName`, perhaps with a unit: unitOf()), from the lines of
/// .obj (ReadObj.h), .csv (ReadCsvCurves.h) or .dxf (ReadDxfCurves.h), or else from text, one curve
/// a line:
///
///     TYPE NAME v0 v1 ...      # TYPE is accessory, key, straight, dart or seam, in any case
///     edge NAME v0 v1 ...      # an accessory curve along the boundary from each vertex to the
///     next
///
/// with 0-based vertex ids of the surface's file; a NAME with blanks stands in double quotes. Text
/// curves come back as polylines on the surface's points. The note says what of the file is no
/// curve that is read. Throws InputError.
CurveContents readCurves(const std::string& path, const DataSet& surface);
}
