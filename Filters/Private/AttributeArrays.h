// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Columns.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkCellData;
class vtkFieldData;
class vtkPointData;
class vtkPolyData;
class vtkTable;

namespace flattening::bridge
{
/// The data's arrays that have a value for each point, with the same active attributes. An array
/// that is too short, as VTK lets it be, would be read beyond its end. \param warnings get a
/// sentence for each that is left out, or whose texts were changed by withoutNul().
vtkSmartPointer<vtkPointData> wholePointArrays(
  vtkPolyData* data, std::vector<std::string>& warnings);

/// The same for cells.
vtkSmartPointer<vtkCellData> wholeCellArrays(vtkPolyData* data, std::vector<std::string>& warnings);

/// Adds the columns as arrays. Field data is lists of their own lengths: one without rows is left
/// out, as it would only clutter tables and panels.
void addColumns(vtkFieldData* field, const Columns& columns);

/// Replaces what a table has by the columns.
void writeTable(const Columns& columns, vtkTable* table);
vtkSmartPointer<vtkTable> makeTable(const Columns& columns);

/// The texts of a cell array, a text a cell; none where there is no such array.
std::vector<std::string> textsOfCells(vtkPolyData* data, const char* array);

/// The field data, whose arrays may have any length.
vtkSmartPointer<vtkFieldData> fieldArrays(vtkPolyData* data, std::vector<std::string>& warnings);
}
