// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace wirewarp
{
struct SurfaceContents
{
  vtkSmartPointer<vtkPolyData> surface; ///< of .vtp and .vtk with the polylines among its cells
  vtkSmartPointer<vtkPolyData> curves;  ///< of .obj, over the same points; null where there is none
};

/// Reads a surface by its extension: .vtp .vtk .obj .ply .stl. Throws InputError.
SurfaceContents readSurface(const std::string& path);
}
