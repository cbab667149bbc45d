// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"
#include "FieldArrays.h"
#include "Quality/FlatteningQuality.h"

class vtkCellArray;
class vtkPoints;

namespace flattening
{
namespace bridge
{
/// VTK points of double precision.
vtkSmartPointer<vtkPoints> makePoints(const Points3& points);
/// The same in the plane z = 0.
vtkSmartPointer<vtkPoints> makePoints(const Points2& points);

vtkSmartPointer<vtkCellArray> makeTriangles(const Triangles& triangles);

/// Copies the data of the cell that each triangle is of, and adds `vtkOriginalCellIds`.
void copyCellData(
  vtkCellData* input, const std::vector<vtkIdType>& cellOfTriangle, vtkPolyData* output);

/// Fills a data set with the imprinted surface, with the input's point and cell data (interpolated
/// at points made by imprinting) and field data, `vtkOriginalCellIds` and `vtkOriginalPointIds`.
void writeImprintedSurface(const CurvedSurface& source, vtkPolyData* output);

/// The same for a cut surface over the given points, with `PieceId`.
void writeCutSurface(
  const CurvedSurface& source, const CutSurface& cut, vtkPoints* points, vtkPolyData* output);

/// Adds the field data `SeamPairs`.
void writeSeamPairs(const CutSurface& cut, vtkPolyData* output);

/// Adds `HomogeneityOfDistortion`, `AspectRatio`, `AreaRatio`, `AngleError` and `Flipped` to the
/// cells.
void writeTriangleQuality(const std::vector<TriangleQuality>& quality, vtkPolyData* output);

/// A summary of a flattening as one row of each of its columns in the field data.
void writeSummaries(const std::vector<QualitySummary>& summaries, vtkFieldData* field);
}
}
