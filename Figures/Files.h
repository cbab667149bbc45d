// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <functional>
#include <string>

class vtkPatternWriter;

namespace figures
{
/// Keeps an object's warnings and errors from VTK's own window; filters and writers of this project
/// give them again by their status.
void silence(vtkObject* object);

/// Writes .vtp aside first, so that an earlier file stays where it cannot be written. Throws
/// std::runtime_error.
void writePolyData(const std::string& path, vtkPolyData* data);

/// Writes a pattern as .svg, .pdf, .dxf, .plt or .json, by the extension. Throws
/// std::runtime_error.
/// \param unit of the piece's coordinates, "mm"
void writePattern(const std::string& path, const FlatPiece& piece, const std::string& unit);
/// \param writer has the options, and is given the piece and the path
/// \param words how to say what the writer refuses; empty: as it does itself
void writePattern(const std::string& path, const FlatPiece& piece, vtkPatternWriter* writer,
  const std::function<std::string(const vtkPatternWriter*)>& words = {});
}
