// SPDX-License-Identifier: BSD-3-Clause
// Pieces are a table of their own, per block and for a rejected surface as well.
#include "FlatteningTesting.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkWireWarpingFilter.h"

#include <algorithm>

using namespace flatteningTesting;

namespace
{
std::string firstColumns(vtkTable* table, vtkIdType count)
{
  std::string names;
  for (vtkIdType c = 0; c < std::min(count, table->GetNumberOfColumns()); ++c)
  {
    names += std::string(c ? " " : "") + table->GetColumnName(c);
  }
  return names;
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
  const auto apart =
    makePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 9, 0, 0 }, { 9, 1, 0 }, { 8, 0, 0 } },
      { { 0, 1, 2 }, { 3, 4, 5 } });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, apart);
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(2, makeGrid(3, 3));
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputDataObject(blocks);
  filter->Update();
  auto* const output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(3));
  check.that(output && output->GetNumberOfBlocks() == 3, "tables of three blocks");
  const std::array<int, 3> expected{ 2, 1, 1 };
  for (unsigned int k = 0; output && k < 3; ++k)
  {
    auto* const table = vtkTable::SafeDownCast(output->GetBlock(k));
    check.that(table && table->GetNumberOfRows() == expected[k], "rows of a block");
    check.equal(table ? table->GetValueByName(0, "Status").ToString() : "",
      vtkStdString(k == 1 ? "EmptySurface" : "Ok"), "status of a block");
  }
}
}

int TestPieceTables(int, char*[])
{
  Checks check;
  rejectedSurfaceIsARow(check);
  oneTablePerBlock(check);
  return check.result();
}
