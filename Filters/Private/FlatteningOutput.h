// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedPolyData.h"
#include "Flattening/SurfaceFlattening.h"
#include "Input/Columns.h"

namespace flattening::bridge
{
/// Writes a flattening as the three outputs that vtkWireWarpingFilter documents.
void writeFlattening(const CurvedPolyData& source, const FlatteningResult& result,
  const FlatteningOptions& options, vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut);

/// Writes wires as polylines over the points and point data of `surface`. \param arrays those of
/// wireArrays()
void writeWires(
  const std::vector<Wire>& wires, const Columns& arrays, vtkPolyData* surface, vtkPolyData* output);
}
