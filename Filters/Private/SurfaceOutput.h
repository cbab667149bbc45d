// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedPolyData.h"
#include "Flattening/SurfaceFlattening.h"
#include "PolyDataSets.h"
#include "Report/FlatteningArrays.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkPoints;

namespace flattening::bridge
{
/// Copies the data of the cell that each triangle is of, and adds `vtkOriginalCellIds`.
void copyCellData(
  vtkCellData* input, const std::vector<std::int64_t>& cellOfTriangle, vtkPolyData* output);

/// Writes an imprinted surface and its curves as the two outputs that vtkFeatureCurveImprinter
/// documents. \param warnings get a sentence for each array of the curves that is left out.
void writeImprint(const CurvedPolyData& source, vtkPolyData* surface, vtkPolyData* curves,
  std::vector<std::string>& warnings);

/// Fills a data set with a cut surface over the given points, with the input's point and cell data
/// (interpolated at points made by imprinting), vtkOriginalCellIds and field data. \param arrays
/// its arrays beside those of the input
void writeCutSurface(const CurvedPolyData& source, const CutSurface& cut, const CutArrays& arrays,
  vtkPoints* points, vtkPolyData* output);

/// Writes a flattening as the three outputs that vtkWireWarpingFilter documents.
void writeFlattening(const CurvedPolyData& source, const FlatteningResult& result,
  const FlatteningOptions& options, vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut);

/// Writes wires as polylines over the points and point data of `surface`. \param arrays those of
/// wireArrays()
void writeWires(
  const std::vector<Wire>& wires, const Columns& arrays, vtkPolyData* surface, vtkPolyData* output);
}
