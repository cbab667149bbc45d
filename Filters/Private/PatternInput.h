// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PatternSource.h"
#include "PatternStatus.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// Reads the outputs of vtkWireWarpingFilter.
/// \param wires, cut may be null
pattern::PatternStatus readPattern(
  vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut, pattern::PatternSource& source);
}
}
