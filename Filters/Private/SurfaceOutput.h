// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedPolyData.h"
#include "PolyDataSets.h"
#include "Report/FlatteningArrays.h"

#include <cstdint>
#include <vector>

class vtkPoints;

namespace flattening::bridge
{
/// Copies the data of the cell that each triangle is of, and adds `vtkOriginalCellIds`.
void copyCellData(
  vtkCellData* input, const std::vector<std::int64_t>& cellOfTriangle, vtkPolyData* output);

/// Fills a data set with the imprinted surface, with the input's point and cell data (interpolated
/// at points made by imprinting) and field data, `vtkOriginalCellIds` and `vtkOriginalPointIds`.
void writeImprintedSurface(const CurvedPolyData& source, vtkPolyData* output);

/// The same for a cut surface over the given points. \param arrays its arrays beside those of the
/// input
void writeCutSurface(const CurvedPolyData& source, const CutSurface& cut, const CutArrays& arrays,
  vtkPoints* points, vtkPolyData* output);
}
