// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <string>

class vtkRenderWindow;

namespace figures
{
/// Keeps an object's warnings and errors from VTK's own window; filters and writers of this project
/// give them again by their status.
void silence(vtkObject* object);

/// Writes .vtp aside first, so that an earlier file stays where it cannot be written. Throws
/// std::runtime_error.
void writePolyData(const std::string& path, vtkPolyData* data);

/// Writes what a window shows. Throws std::runtime_error.
void writePng(vtkRenderWindow* window, const std::string& path);
}
