// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Grading/SizeGrading.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// Reads the outputs of vtkWireWarpingFilter.
/// \param wires, cut may be null
Status readPieces(
  vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut, pattern::PatternSource& source);

/// Writes what vtkPatternGrading documents.
void writeGrading(const pattern::Grading& grading, vtkPolyData* output);

/// Reads it again.
/// \return InvalidPattern where arrays are missing, too short, or name what is not there
Status readGrading(vtkPolyData* input, pattern::Grading& grading);
}
}
