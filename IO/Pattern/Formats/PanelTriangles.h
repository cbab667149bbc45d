// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

namespace flattening
{
namespace pattern
{
/// Triangles between the corners of a polygon, counter-clockwise whatever its way round, by a
/// constrained Delaunay triangulation.
/// \param bad where it fails: the side, from the corner of that number, that crosses or touches
/// another
/// \return false where the polygon crosses or touches itself
bool triangulatePolygon(const Points2& polygon, Triangles& triangles, std::size_t& bad);
}
}
