// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/PatternSource.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// Reads the outputs of vtkWireWarpingFilter.
/// \param wires, cut may be null
Status readPieces(
  vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut, pattern::PatternSource& source);
}
}
