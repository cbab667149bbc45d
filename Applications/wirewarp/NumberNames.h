// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>

#include <string>

namespace wirewarp
{
/// A note where curves over the surface's own vertices have numbers as their names, which may be
/// vertices of lines without a name; empty where none has.
std::string notesOfNumberNames(vtkPolyData* surface, vtkPolyData* curves);
}
