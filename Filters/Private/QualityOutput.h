// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "QualityInput.h"

class vtkTable;

namespace flattening
{
namespace bridge
{
/// Measures a mapped surface and writes what vtkFlatteningQuality documents.
void writeQuality(vtkPolyData* input, const MappedSurface& map, std::size_t mostListedOverlaps,
  const Execution& execution, vtkPolyData* output, vtkTable* measures,
  std::vector<std::string>& warnings);
}
}
