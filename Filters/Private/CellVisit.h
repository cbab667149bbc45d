// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkSmartPointer.h"

namespace flattening
{
namespace bridge
{
/// Calls visit(k, count, ids) for each cell of an array, k counting from 0.
template <class Visit>
void forEachCell(vtkCellArray* cells, Visit&& visit)
{
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    visit(cell->GetCurrentCellId(), count, ids);
  }
}
}
}
