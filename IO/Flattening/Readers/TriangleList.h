// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace wirewarp
{
struct ListedTriangle
{
  std::array<vtkIdType, 3> corners;
  vtkIdType polygon = 0; ///< its place among the polygons of the input, whose data it has
};

/// The polygons of a surface as triangles that can be taken out, changed and added. Points and
/// their ids stay as they are, so that curves that name points keep their meaning.
struct TriangleList
{
  vtkSmartPointer<vtkPoints> points;
  std::vector<ListedTriangle> triangles;
};

/// Polygons and strips as the filters divide them. Empty where a cell names a point that does not
/// exist or has no finite place: such a surface is refused as it is.
TriangleList listTriangles(vtkPolyData* surface);

/// The surface with these triangles in place of its polygons; each has the data of the polygon that
/// it is from.
vtkSmartPointer<vtkPolyData> withTriangles(vtkPolyData* surface, const TriangleList& list);

/// Takes triangles without area out of a surface so that it stays whole: corners in one place
/// become one point, and a triangle with three corners in a line is divided among the triangle
/// behind its longest edge, or taken off where that is the boundary.
///
/// Where half of the triangles or more are without area, or where it cannot be done, the list stays
/// as it is.
/// \return the polygons of the triangles without area
std::vector<vtkIdType> mendFlatTriangles(TriangleList& list);
}
