// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleList.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFlatteningAlgorithm.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

namespace wirewarp
{
//------------------------------------------------------------------------------
TriangleList listTriangles(vtkPolyData* surface)
{
  TriangleList list;
  list.points = surface->GetPoints();
  vtkNew<vtkPolyData> divided;
  vtkFlatteningAlgorithm::Triangulate(surface, divided);
  vtkDataArray* const origin = divided->GetCellData()->GetArray("vtkOriginalCellIds");
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  list.triangles.reserve(static_cast<std::size_t>(divided->GetNumberOfPolys()));
  const auto cells = vtk::TakeSmartPointer(divided->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    cells->GetCurrentCell(count, ids);
    const auto cell = static_cast<vtkIdType>(origin->GetComponent(cells->GetCurrentCellId(), 0));
    list.triangles.push_back({ { ids[0], ids[1], ids[2] }, cell - before });
  }
  return list;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> withTriangles(vtkPolyData* surface, const TriangleList& list)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(list.points);
  result->GetPointData()->ShallowCopy(surface->GetPointData());
  result->GetFieldData()->ShallowCopy(surface->GetFieldData());
  result->SetVerts(surface->GetVerts());
  result->SetLines(surface->GetLines());
  vtkNew<vtkCellArray> polygons;
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  vtkCellData* const from = surface->GetCellData();
  vtkCellData* const to = result->GetCellData();
  to->CopyAllOn();
  to->CopyAllocate(from, before + static_cast<vtkIdType>(list.triangles.size()));
  for (vtkIdType cell = 0; cell < before; ++cell)
  {
    to->CopyData(from, cell, cell);
  }
  for (const ListedTriangle& triangle : list.triangles)
  {
    const vtkIdType cell = before + polygons->InsertNextCell(3, triangle.corners.data());
    to->CopyData(from, before + triangle.polygon, cell);
  }
  result->SetPolys(polygons);
  return result;
}
}
