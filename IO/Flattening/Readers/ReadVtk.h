// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace wirewarp
{
/// Reads polydata from .vtp, .vtk or .stl, coordinates in the type that the file has, with VTK's
/// readers. They take much of a file on trust: a damaged one makes them crash, run for ever or ask
/// for all memory. So they run in a program of their own, wirewarp-read, with limits that grow with
/// the file, and hand back data that is checked. Throws InputError.
vtkSmartPointer<vtkPolyData> readVtk(const std::string& path);

///@{
/// The first letter of what that program answers; the packed data or what is wrong follows.
inline constexpr char vtkAnswerData = 'd';
inline constexpr char vtkAnswerRefusal = 'r';
///@}
}
