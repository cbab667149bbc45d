// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <string>

namespace wirewarp
{
/// Reads feature curves from the entities LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE and
/// SPLINE of an ASCII DXF file, all releases. The layer
/// gives type and name: "dart left", see CurveList.h. Coordinates are those of the surface. The
/// note names other entities, but for texts, points and dimensions. Throws InputError.
CurveContents readDxfCurves(const std::string& path);
}
