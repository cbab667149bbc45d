// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace wirewarp
{
/// Reads OFF, the Object File Format of Geomview, as text; colours, normals and texture (COFF,
/// NOFF, STOFF) are passed over. Throws InputError with file and line.
vtkSmartPointer<vtkPolyData> readOff(const std::string& path);
}
