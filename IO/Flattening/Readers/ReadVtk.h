// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <string>

namespace wirewarp
{
/// Reads polydata from .vtp, .vtk, .gltf or .glb, coordinates in the type that the file has, with
/// VTK's readers. They take much of a file on trust: a damaged one makes them crash, run for ever
/// or ask for all memory. So they run in a program of their own, wirewarp-read, with limits that
/// grow with the file, and hand back data that is checked. Throws InputError.
DataSet readVtk(const std::string& path);

///@{
/// The first letter of what that program answers; the packed data or what is wrong follows.
inline constexpr char vtkAnswerData = 'd';
inline constexpr char vtkAnswerRefusal = 'r';
///@}
}
