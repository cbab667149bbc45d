// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/PatternSource.h"

class vtkFieldData;
class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// Writes pieces as vtkWireWarpingFilter does, so that readPattern() reads them: what
/// vtkGarmentCodeReader documents.
void writePatternSource(
  const pattern::PatternSource& source, vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut);
}
}
