// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataSets.h"

#include "AttributeArrays.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace flattening::bridge
{
namespace
{
CellList cellsOf(vtkCellArray* cells)
{
  CellList list;
  list.offsets.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()) + 1);
  list.ids.reserve(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    list.ids.insert(list.ids.end(), ids, ids + count);
    list.offsets.push_back(static_cast<std::int64_t>(list.ids.size()));
  }
  return list;
}

vtkNew<vtkTypeInt64Array> arrayOf(const std::vector<std::int64_t>& values)
{
  vtkNew<vtkTypeInt64Array> array;
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

template <class Value>
std::vector<Value> valuesOf(vtkDataArray* array)
{
  std::vector<Value> values;
  const int components = array->GetNumberOfComponents();
  values.reserve(static_cast<std::size_t>(array->GetNumberOfValues()));
  for (vtkIdType row = 0; row < array->GetNumberOfTuples(); ++row)
  {
    for (int c = 0; c < components; ++c)
    {
      values.push_back(static_cast<Value>(array->GetComponent(row, c)));
    }
  }
  return values;
}

ColumnValues numbersOf(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return valuesOf<double>(array);
    case VTK_INT:
      return valuesOf<int>(array);
    case VTK_BIT:
    case VTK_UNSIGNED_CHAR:
      return valuesOf<unsigned char>(array);
    default:
      return valuesOf<std::int64_t>(array);
  }
}

void setRoles(const Columns& columns, vtkDataSetAttributes* arrays)
{
  for (const Column& column : columns)
  {
    if (column.role != ArrayRole::None)
    {
      arrays->SetActiveAttribute(column.name.c_str(), static_cast<int>(column.role));
    }
  }
}
}

Columns columnsOf(vtkFieldData* arrays)
{
  Columns columns;
  auto* const attributes = vtkDataSetAttributes::SafeDownCast(arrays);
  for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = arrays->GetAbstractArray(k);
    // VTK's XML readers refuse a file with a name that is empty.
    if (!array->GetName() || !*array->GetName() || array->GetNumberOfComponents() < 1)
    {
      continue;
    }
    Column column{ array->GetName(), {}, array->GetNumberOfComponents() };
    if (auto* const numbers = vtkDataArray::SafeDownCast(array))
    {
      column.values = numbersOf(numbers);
    }
    else if (auto* const texts = vtkStringArray::SafeDownCast(array))
    {
      std::vector<std::string> values;
      for (vtkIdType row = 0; row < texts->GetNumberOfValues(); ++row)
      {
        values.push_back(texts->GetValue(row));
      }
      column.values = std::move(values);
    }
    else
    {
      continue;
    }
    column.role =
      attributes ? static_cast<ArrayRole>(attributes->IsArrayAnAttribute(k)) : ArrayRole::None;
    columns.push_back(std::move(column));
  }
  return columns;
}

DataSet geometryOf(vtkPolyData* data)
{
  DataSet set;
  Points3 points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    data->GetPoint(static_cast<vtkIdType>(p), points[p].data());
  }
  set.points = std::make_shared<const Points3>(std::move(points));
  set.vertexCells = static_cast<std::size_t>(data->GetNumberOfVerts());
  set.lines = cellsOf(data->GetLines());
  set.faces = cellsOf(data->GetPolys());
  set.strips = cellsOf(data->GetStrips());
  const auto add = [](vtkDataArray* array, ArrayRole role, Columns& columns) {
    if (array && array->GetNumberOfComponents() > 0)
    {
      columns.push_back({ array->GetName() ? array->GetName() : "", numbersOf(array),
        array->GetNumberOfComponents(), role });
    }
  };
  add(data->GetPointData()->GetTCoords(), ArrayRole::TextureCoordinates, set.pointArrays);
  add(data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()), ArrayRole::None,
    set.cellArrays);
  return set;
}

DataSet dataSetOf(vtkPolyData* data)
{
  DataSet set = geometryOf(data);
  set.pointArrays = columnsOf(data->GetPointData());
  set.cellArrays = columnsOf(data->GetCellData());
  set.fieldArrays = columnsOf(data->GetFieldData());
  return set;
}

void fill(vtkPolyData* output, const DataSet& data)
{
  output->SetPoints(makePoints(*data.points));
  const std::array<std::pair<const CellList*, void (vtkPolyData::*)(vtkCellArray*)>, 3> lists{
    { { &data.lines, &vtkPolyData::SetLines }, { &data.faces, &vtkPolyData::SetPolys },
      { &data.strips, &vtkPolyData::SetStrips } }
  };
  for (const auto& [list, set] : lists)
  {
    (output->*set)(makeCells(*list));
  }
  addColumns(output->GetPointData(), data.pointArrays);
  addColumns(output->GetCellData(), data.cellArrays);
  addColumns(output->GetFieldData(), data.fieldArrays);
  setRoles(data.pointArrays, output->GetPointData());
  setRoles(data.cellArrays, output->GetCellData());
}

vtkSmartPointer<vtkPoints> makePoints(const Points3& points)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  result->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  auto* out = static_cast<double*>(result->GetVoidPointer(0));
  for (const Point3& p : points)
  {
    out = std::copy_n(p.data(), 3, out);
  }
  return result;
}

vtkSmartPointer<vtkPoints> makePoints(const Points2& points)
{
  Points3 places;
  places.reserve(points.size());
  for (const Point2& p : points)
  {
    places.emplace_back(p.x(), p.y(), 0.0);
  }
  return makePoints(places);
}

vtkSmartPointer<vtkCellArray> makeCells(const CellList& cells)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(arrayOf(cells.offsets), arrayOf(cells.ids));
  return result;
}

vtkSmartPointer<vtkCellArray> makeTriangles(const Triangles& triangles)
{
  CellList cells;
  for (const Triangle& t : triangles)
  {
    cells.add(t);
  }
  return makeCells(cells);
}
}
