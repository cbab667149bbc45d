// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"
#include "vtkSmartPointer.h"

class vtkCellArray;
class vtkFieldData;
class vtkPoints;
class vtkPolyData;

namespace flattening::bridge
{
/// Points and cells, with the ghost cells and texture coordinates. \pre the cells are valid
DataSet geometryOf(vtkPolyData* data);

/// The same with all arrays that have names and hold numbers or texts.
DataSet dataSetOf(vtkPolyData* data);

/// Those of point, cell or field data.
Columns columnsOf(vtkFieldData* arrays);

/// Gives an empty output what a data set holds.
void fill(vtkPolyData* output, const DataSet& data);

/// VTK points of double precision.
vtkSmartPointer<vtkPoints> makePoints(const Points3& points);
/// The same in the plane z = 0.
vtkSmartPointer<vtkPoints> makePoints(const Points2& points);

vtkSmartPointer<vtkCellArray> makeCells(const CellList& cells);
vtkSmartPointer<vtkCellArray> makeTriangles(const Triangles& triangles);
}
