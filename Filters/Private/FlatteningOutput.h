// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"
#include "Flattening/SurfaceFlattening.h"

namespace flattening
{
namespace bridge
{
/// Writes a flattening as the three outputs that vtkWireWarpingFilter documents.
void writeFlattening(const CurvedSurface& source, const FlatteningResult& result, vtkPolyData* flat,
  vtkPolyData* wires, vtkPolyData* cut);

/// `SheetMaterial` among the field data of flat pieces, where the edges of their material do not
/// fray.
void writeSheetMaterial(const FlatteningOptions& options, vtkPolyData* flat);

/// A sentence that names the pieces that were left out, by cells of the input.
std::string describeLeftOut(const CurvedSurface& source, const FlatteningResult& result);

/// Writes wires as polylines over the points and point data of `surface`, with the cell arrays
/// `CurveType`, `CurveId`, `CurveName`, `PieceId`, `Boundary` and `RestLength`.
void writeWires(const std::vector<Wire>& wires, const std::vector<FeatureCurve>& curves,
  vtkPolyData* surface, vtkPolyData* output);
}
}
