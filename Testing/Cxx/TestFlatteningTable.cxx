// SPDX-License-Identifier: BSD-3-Clause
// Tables of pieces and of curves hold the numbers of the field data, all that have such rows and no
// others.
#include "FlatteningTesting.h"

#include "vtkFlatteningTable.h"
#include "vtkSewnShape.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkWireWarpingFilter.h"

#include <cmath>
#include <set>

using namespace flatteningTesting;

namespace
{
/// Curved, so that there is more than one iteration a piece.
double bulge(double x, double y)
{
  return 0.3 * std::sin(2.0 * x) * std::sin(2.0 * y);
}

/// A surface of so many separate sheets.
vtkSmartPointer<vtkPolyData> sheets(int count)
{
  const vtkSmartPointer<vtkPolyData> surface = makeGrid(4, 3, bulge);
  for (int k = 1; k < count; ++k)
  {
    const vtkIdType first = surface->GetNumberOfPoints();
    const vtkSmartPointer<vtkPolyData> sheet = makeGrid(3 + k, 3, bulge);
    for (vtkIdType p = 0; p < sheet->GetNumberOfPoints(); ++p)
    {
      double point[3];
      sheet->GetPoint(p, point);
      surface->GetPoints()->InsertNextPoint(point[0] + 10.0 * k, point[1], point[2]);
    }
    vtkNew<vtkIdList> corners;
    for (vtkIdType c = 0; c < sheet->GetNumberOfCells(); ++c)
    {
      sheet->GetCellPoints(c, corners);
      for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
      {
        corners->SetId(i, corners->GetId(i) + first);
      }
      surface->GetPolys()->InsertNextCell(corners);
    }
  }
  surface->Modified();
  return surface;
}

/// Names of the arrays whose number of values follows the number of rows.
std::set<std::string> arraysPerRow(
  vtkFieldData* few, vtkIdType fewRows, vtkFieldData* many, vtkIdType manyRows)
{
  std::set<std::string> names;
  for (int k = 0; k < few->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = few->GetAbstractArray(k);
    vtkAbstractArray* const other = many->GetAbstractArray(array->GetName());
    if (array->GetNumberOfTuples() == fewRows && other && other->GetNumberOfTuples() == manyRows &&
      array->GetNumberOfComponents() == 1)
    {
      names.insert(array->GetName());
    }
  }
  return names;
}

std::set<std::string> columnsOf(vtkTable* table)
{
  std::set<std::string> names;
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    names.insert(table->GetColumnName(c));
  }
  return names;
}

std::string listed(const std::set<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += name + ' ';
  }
  return text;
}

void compareValues(Checks& check, vtkTable* table, vtkFieldData* field)
{
  for (const std::string& name : columnsOf(table))
  {
    vtkAbstractArray* const array = field->GetAbstractArray(name.c_str());
    for (vtkIdType row = 0; array && row < table->GetNumberOfRows(); ++row)
    {
      check.equal(table->GetValueByName(row, name.c_str()).ToString(),
        array->GetVariantValue(row).ToString(), name);
    }
  }
}

void aRowAPiece(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> three;
  three->SetInputData(sheets(3));
  vtkNew<vtkWireWarpingFilter> five;
  five->SetInputData(sheets(5));
  five->Update();
  vtkNew<vtkFlatteningTable> table;
  table->SetInputConnection(three->GetOutputPort());
  table->Update();
  vtkFieldData* const field = three->GetOutput()->GetFieldData();
  check.equal(table->GetOutput()->GetNumberOfRows(), vtkIdType{ 3 }, "rows of three pieces");
  std::set<std::string> expected = arraysPerRow(field, 3, five->GetOutput()->GetFieldData(), 5);
  expected.insert("Piece");
  check.equal(listed(columnsOf(table->GetOutput())), listed(expected), "columns of pieces");
  compareValues(check, table->GetOutput(), field);

  for (vtkWireWarpingFilter* const filter : { three.GetPointer(), five.GetPointer() })
  {
    filter->SetMaterial("twill");
    filter->Update();
  }
  table->Update();
  expected = arraysPerRow(field, 3, five->GetOutput()->GetFieldData(), 5);
  expected.insert("Piece");
  check.that(expected.count("GrainAngle") == 1, "there are arrays of a material");
  check.equal(listed(columnsOf(table->GetOutput())), listed(expected), "columns of a material");
  compareValues(check, table->GetOutput(), field);
}

void aRowASewnShape(Checks& check)
{
  const auto sew = [](int sheetCount, const char* material) {
    vtkNew<vtkWireWarpingFilter> flat;
    flat->SetInputData(sheets(sheetCount));
    auto sewn = vtkSmartPointer<vtkSewnShape>::New();
    sewn->SetInputConnection(flat->GetOutputPort(0));
    sewn->SetDesignConnection(flat->GetOutputPort(2));
    sewn->SetMaterial(material);
    sewn->Update();
    return sewn;
  };
  for (const char* const material : { "", "twill" })
  {
    const auto three = sew(3, material);
    const auto five = sew(5, material);
    vtkNew<vtkFlatteningTable> table;
    table->SetInputConnection(three->GetOutputPort());
    table->Update();
    vtkFieldData* const field = three->GetOutput()->GetFieldData();
    std::set<std::string> expected = arraysPerRow(field, 3, five->GetOutput()->GetFieldData(), 5);
    expected.insert("Shape");
    check.that(expected.count("DistanceMax") == 1, "there are distances");
    check.equal(listed(columnsOf(table->GetOutput())), listed(expected), "columns of shapes");
    compareValues(check, table->GetOutput(), field);
  }
}

void aRowACurve(Checks& check)
{
  const auto run = [](const std::vector<Cell>& lines) {
    auto filter = vtkSmartPointer<vtkWireWarpingFilter>::New();
    const vtkSmartPointer<vtkPolyData> surface = makeGrid(5, 5);
    for (const Cell& line : lines)
    {
      addLine(surface, line);
    }
    filter->SetInputData(surface);
    filter->Update();
    return filter;
  };
  const auto two = run({ { 7, 8, 9 }, { 13, 14, 15, 16 } });
  const auto three = run({ { 7, 8, 9 }, { 13, 14, 15, 16 }, { 25, 26, 27 } });
  vtkNew<vtkFlatteningTable> table;
  table->SetInputConnection(two->GetOutputPort(1));
  table->Update();
  vtkFieldData* const field = two->GetOutput(1)->GetFieldData();
  check.equal(table->GetOutput()->GetNumberOfRows(), vtkIdType{ 2 }, "rows of two curves");
  check.equal(listed(columnsOf(table->GetOutput())),
    listed(arraysPerRow(field, 2, three->GetOutput(1)->GetFieldData(), 3)), "columns of curves");
  compareValues(check, table->GetOutput(), field);
}

void aRefusedSurfaceIsARow(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages ofFilter(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  vtkNew<vtkFlatteningTable> table;
  const Messages messages(table);
  table->SetInputConnection(filter->GetOutputPort());
  table->Update();
  vtkTable* const output = table->GetOutput();
  check.equal(output->GetNumberOfRows(), vtkIdType{ 1 }, "rows of a refused surface");
  check.equal(listed(columnsOf(output)), std::string("Piece Status StatusMessage "), "its columns");
  check.equal(output->GetValueByName(0, "Piece").ToInt(), -1, "its piece");
  check.equal(
    output->GetValueByName(0, "Status").ToString(), vtkStdString("EmptySurface"), "its status");
  check.equal(output->GetValueByName(0, "StatusMessage").ToString(),
    vtkStdString(filter->GetStatusMessage()), "its message");
  check.equal(messages.warnings.size(), std::size_t{ 0 }, "warnings of a refused surface");
}

void otherDataIsWarnedOf(Checks& check)
{
  vtkNew<vtkFlatteningTable> table;
  const Messages messages(table);
  table->SetInputData(makeGrid(2, 2));
  table->Update();
  check.equal(table->GetOutput()->GetNumberOfColumns(), vtkIdType{ 0 }, "columns of a plain grid");
  check.equal(messages.warnings.size(), std::size_t{ 1 }, "warnings of a plain grid");
}
}

int TestFlatteningTable(int, char*[])
{
  Checks check;
  aRowAPiece(check);
  aRowASewnShape(check);
  aRowACurve(check);
  aRefusedSurfaceIsARow(check);
  otherDataIsWarnedOf(check);
  return check.result();
}
