// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Input/Columns.h"
#include "Input/MappedSurface.h"

#include <cstddef>
#include <vector>

namespace flattening
{
/// What vtkFlatteningQuality documents.
struct QualityReport
{
  Columns measures;    ///< one row
  Columns cells;       ///< of the triangles of the input
  Column overlapEdges; ///< points of the input
};

/// Measures a flattening of any origin. \param most overlaps that are listed
QualityReport reportQuality(const MappedSurface& map, std::size_t most, const Execution& execution);

/// `Developability` of the points of the input; 0 where no triangle uses one.
Column developabilityOfPoints(const LoadedSurface& surface, const Execution& execution);
}
