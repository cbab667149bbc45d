// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <string>

namespace editor
{
/// Files of surfaces (.vtp, .vtk, .obj, .ply, .stl), curves (.vtp, .vtk) and patterns (.svg, .pdf,
/// .dxf). All throw std::runtime_error with a sentence for the user.
figures::PolyData readPolyData(const std::string& path);
/// As .vtp; aside first, so that an earlier file stays where it cannot be written.
void writePolyData(const std::string& path, vtkPolyData* data);
void writePattern(const std::string& path, const figures::FlatPiece& piece, const std::string& unit,
  const std::string& name);

/// "shirt" of "/somewhere/shirt.vtp".
std::string stemOf(const std::string& path);
}
