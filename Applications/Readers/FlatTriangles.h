// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TriangleList.h"

namespace wirewarp
{
/// Takes triangles without area out of a surface so that it stays whole: corners in one place
/// become one point, and a triangle with three corners in a line is divided among the triangle
/// behind its longest edge, or taken off where that is the boundary.
///
/// Where half of the triangles or more are without area, or where it cannot be done, the list stays
/// as it is.
/// \return the polygons of the triangles without area
std::vector<vtkIdType> mendFlatTriangles(TriangleList& list);
}
