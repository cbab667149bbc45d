// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/InputSurface.h"
#include "Surface/SurfacePreparation.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkPolyData;
class vtkUnsignedCharArray;

namespace flattening
{
namespace bridge
{
/// Which cells that vtkGhostType marks are read.
enum class GhostCells
{
  LeftOut,    ///< neither hidden ones nor copies of other processes' cells
  Duplicates, ///< also those copies, for what is computed around a point
};

/// Whether a cell of the data is to be read.
class CellChoice
{
public:
  CellChoice(vtkPolyData* data, GhostCells ghosts);
  bool reads(vtkIdType cell) const;

private:
  vtkUnsignedCharArray* Ghosts;
  int LeftOut;
};

/// The polygons and strips, but ghost cells.
SurfaceTriangles readTriangles(vtkPolyData* surface, GhostCells ghosts = GhostCells::LeftOut);

LoadedSurface loadSurface(vtkPolyData* surface, CoincidentPoints coincident, Defects defects,
  GhostCells ghosts = GhostCells::LeftOut);

/// Reads a body; null: there is none.
LoadedBody loadBody(vtkPolyData* body);

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
