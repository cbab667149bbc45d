// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace wirewarp
{
/// Reads a surface by its extension: .vtp .vtk .obj .ply .stl. Throws InputError.
vtkSmartPointer<vtkPolyData> readSurface(const std::string& path);
}
