// SPDX-License-Identifier: BSD-3-Clause
// Pieces and curves are tables of their own, per block and for a rejected surface as well.
#include "FlatteningTesting.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkWireWarpingFilter.h"

#include <cmath>

using namespace flatteningTesting;

namespace
{
double bulge(double x, double y)
{
  return 0.3 * std::sin(2.0 * x) * std::sin(2.0 * y);
}

/// A surface of separate sheets.
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

std::string firstColumns(vtkTable* table, vtkIdType count)
{
  std::string names;
  for (vtkIdType c = 0; c < std::min(count, table->GetNumberOfColumns()); ++c)
  {
    names += std::string(c ? " " : "") + table->GetColumnName(c);
  }
  return names;
}

void oneRowPerPiece(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputData(sheets(3));
  filter->Update();
  const vtkSmartPointer<vtkTable> pieces = filter->GetPieces();
  check.equal(pieces->GetNumberOfRows(), vtkIdType{ 3 }, "rows of three pieces");
  check.equal(firstColumns(pieces, 3), std::string("Piece Status Name"), "first columns");
  for (vtkIdType row = 0; row < 3; ++row)
  {
    check.equal(
      pieces->GetValueByName(row, "Piece").ToInt(), static_cast<int>(row), "number of a piece");
    check.equal(pieces->GetValueByName(row, "Status").ToString(), vtkStdString("Ok"), "status");
    check.equal(pieces->GetValueByName(row, "Triangles").ToInt(),
      static_cast<int>(row == 0 ? 24 : 6 * (3 + row)), "triangles");
    check.that(pieces->GetValueByName(row, "AreaError").ToDouble() > 0.0, "area error");
  }
  check.that(!pieces->GetColumnByName("GrainAngle"), "no columns of a material");
  vtkTable* const iterations = filter->GetIsometricIterations();
  check.equal(firstColumns(iterations, 1), std::string("Piece"), "first column of iterations");
  check.equal(iterations->GetValueByName(iterations->GetNumberOfRows() - 1, "Piece").ToInt(), 2,
    "piece of the last iteration");

  filter->SetMaterial("twill");
  filter->Update();
  check.equal(filter->GetPieces()->GetValueByName(2, "StrainWarpRms").ToDouble() > 0.0, true,
    "a column of a material");
  check.equal(filter->GetPieces()->GetNumberOfRows(), vtkIdType{ 3 }, "rows with a material");
}

void oneRowPerCurve(Checks& check)
{
  const vtkSmartPointer<vtkPolyData> surface = makeGrid(5, 5);
  addLine(surface, { 7, 8, 9 });
  addLine(surface, { 13, 14, 15, 16 });
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputData(surface);
  filter->Update();
  vtkTable* const curves = filter->GetCurves();
  check.equal(curves->GetNumberOfRows(), vtkIdType{ 2 }, "rows of two curves");
  check.equal(firstColumns(curves, 3), std::string("Curve Name Type"), "first columns of curves");
  check.equal(curves->GetValueByName(1, "Name").ToString(), vtkStdString("curve 1"), "name");
  check.equal(curves->GetValueByName(1, "Type").ToString(), vtkStdString("accessory"), "type");
  check.near(curves->GetValueByName(1, "RestLength").ToDouble(), 0.6, 1e-12, "rest length");
  check.near(curves->GetValueByName(1, "FlatLength").ToDouble(), 0.6, 1e-9, "flat length");
}

void rejectedSurfaceIsARow(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  vtkTable* const pieces = filter->GetPieces();
  check.equal(pieces->GetNumberOfRows(), vtkIdType{ 1 }, "rows of a rejected surface");
  check.equal(firstColumns(pieces, 9), std::string("Piece Status Name StatusMessage"), "columns");
  check.equal(pieces->GetValueByName(0, "Piece").ToInt(), -1, "its piece");
  check.equal(
    pieces->GetValueByName(0, "Status").ToString(), vtkStdString("EmptySurface"), "its status");
  check.equal(pieces->GetValueByName(0, "StatusMessage").ToString(),
    vtkStdString(filter->GetStatusMessage()), "its message");
  check.equal(filter->GetCurves()->GetNumberOfRows(), vtkIdType{ 0 }, "rows of curves");
  check.equal(filter->GetAngleIterations()->GetNumberOfRows(), vtkIdType{ 0 }, "iterations");
}

void oneTablePerBlock(Checks& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sheets(2));
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(2, sheets(1));
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputDataObject(blocks);
  filter->Update();
  auto* const output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(3));
  check.that(output && output->GetNumberOfBlocks() == 3, "tables of three blocks");
  const std::array<int, 3> rows{ 2, 1, 1 };
  for (unsigned int k = 0; output && k < 3; ++k)
  {
    auto* const table = vtkTable::SafeDownCast(output->GetBlock(k));
    check.that(table && table->GetNumberOfRows() == rows[k], "rows of a block");
    check.equal(table ? table->GetValueByName(0, "Status").ToString() : "",
      vtkStdString(k == 1 ? "EmptySurface" : "Ok"), "status of a block");
  }
}
}

int TestPieceTables(int, char*[])
{
  Checks check;
  oneRowPerPiece(check);
  oneRowPerCurve(check);
  rejectedSurfaceIsARow(check);
  oneTablePerBlock(check);
  return check.result();
}
