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
}
