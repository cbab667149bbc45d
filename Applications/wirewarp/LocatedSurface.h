// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>

namespace wirewarp
{
std::array<double, 3> pointOf(vtkPolyData* data, vtkIdType p);

/// Whether VTK's locators can be asked about a point: not where the filters refuse it, since VTK
/// 9.6 ends the program where a coordinate is no number.
bool canBeLocated(const std::array<double, 3>& point);

/// The triangles of a surface for VTK's locators, polygons divided as the filters do: a quad that
/// is not flat has its middle elsewhere. Null where there are none, or a polygon has an id or a
/// point that the filters refuse.
vtkSmartPointer<vtkPolyData> locatedTriangles(vtkPolyData* surface);
}
