// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace wirewarp
{
/// Reads Wavefront OBJ with coordinates in double precision.
///
/// `v`, `f` (polygons; `v`, `v/vt`, `v//vn`, `v/vt/vn`; negative ids count from the end) and `l`
/// are read, everything else is passed over. Point k is the k-th `v` line: texture seams split
/// nothing. Throws InputError with file and line.
vtkSmartPointer<vtkPolyData> readObj(const std::string& path);
}
