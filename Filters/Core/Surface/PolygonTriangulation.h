// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

namespace flattening
{
/// Divides a polygon by diagonals into corners.size() - 2 triangles, by clipping ears (G. H.
/// Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975), with exact orientations
/// in the coordinate plane that is the most parallel to it.
///
/// The polygon may touch itself, as a face does whose hole is joined to its outline by a bridge
/// that is run through twice. Triangles have area where the polygon has; one without area gives
/// triangles without area. One that crosses itself is divided as well, with some triangles turned
/// over.
/// \pre corners are finite points, at least three
Triangles triangulatePolygon(const Points3& points, const Indices& corners);

/// Whether the triangles, found by other means, are as many, and each has area and the polygon's
/// orientation.
bool isTriangulationOf(const Triangles& triangles, const Points3& points, const Indices& corners);
}
