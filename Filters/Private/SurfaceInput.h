// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/SurfaceHealing.h"
#include "Surface/SurfacePreparation.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;
class vtkUnsignedCharArray;

namespace flattening
{
namespace bridge
{
/// The polygons and strips of a vtkPolyData, but ghost cells, as triangles over all of its points.
struct SurfaceTriangles
{
  Points3 points;
  Triangles triangles; ///< those of one cell in a row, cells in order
  std::vector<vtkIdType> cellOfTriangle;
  Status outcome;
};

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

SurfaceTriangles readTriangles(vtkPolyData* surface, GhostCells ghosts = GhostCells::LeftOut);

/// What is done about defects of a surface.
enum class Defects
{
  Heal,      ///< where it is clear how, see healSurface()
  HealParts, ///< the same, but for specks
  Refuse,    ///< but for triangles that are turned over
};

/// A surface read and made into a mesh, or refused in the ids of the input.
struct LoadedSurface
{
  /// Once it is healed, the triangles of the mesh.
  SurfaceTriangles input;
  HealedSurface prepared;
  Status outcome;
  std::vector<std::string> mendings; ///< a sentence for each kind of defect, with cells as ids
};

LoadedSurface loadSurface(vtkPolyData* surface, CoincidentPoints coincident, Defects defects,
  GhostCells ghosts = GhostCells::LeftOut);

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
