// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"
#include "Quality/FlatteningQuality.h"
#include "TableColumns.h"

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

/// Adds the columns of summaries of flattenings. \param summaryOf the summary of a row
template <class Row, class SummaryOf>
void addSummaries(const TableColumns<Row>& columns, SummaryOf summaryOf)
{
  const auto add = [&](const char* name, double QualitySummary::*value) {
    columns.add(name, [&](const Row& row) { return summaryOf(row).*value; });
  };
  add("EdgeLengthError", &QualitySummary::edgeLengthError);
  add("MaxEdgeLengthError", &QualitySummary::maximumEdgeLengthError);
  add("EdgeLengthErrorAll", &QualitySummary::edgeLengthErrorAll);
  add("AngleErrorMean", &QualitySummary::angleError);
  add("GlobalHomogeneity", &QualitySummary::globalHomogeneity);
  add("GlobalAspectRatio", &QualitySummary::globalAspectRatio);
  add("AreaError", &QualitySummary::areaError);
  add("StrainP95", &QualitySummary::strainP95);
  add("RigidEnergy", &QualitySummary::rigidEnergy);
  columns.add("FlippedTriangles", [&](const Row& row) { return summaryOf(row).flipped.size(); });
}
}
}
