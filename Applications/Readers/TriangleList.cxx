// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleList.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>

namespace wirewarp
{
namespace
{
bool isSound(vtkPolyData* surface)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  if (surface->GetNumberOfStrips() > 0 || !surface->GetPolys()->IsValid())
  {
    return false;
  }
  for (vtkIdType p = 0; p < points; ++p)
  {
    double x[3];
    surface->GetPoint(p, x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      return false;
    }
  }
  bool sound = true;
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); sound && !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    cells->GetCurrentCell(count, ids);
    sound = std::all_of(ids, ids + count, [points](vtkIdType p) { return p >= 0 && p < points; });
  }
  return sound;
}

void append(TriangleList& list, vtkCellArray* polygons, vtkDataArray* origin)
{
  const auto cells = vtk::TakeSmartPointer(polygons->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    cells->GetCurrentCell(count, ids);
    const vtkIdType cell = cells->GetCurrentCellId();
    list.triangles.push_back({ { ids[0], ids[1], ids[2] },
      origin ? static_cast<vtkIdType>(origin->GetComponent(cell, 0)) : cell });
  }
}
}

//------------------------------------------------------------------------------
TriangleList listTriangles(vtkPolyData* surface)
{
  TriangleList list;
  list.points = surface->GetPoints();
  vtkCellArray* const polygons = surface->GetPolys();
  if (polygons->GetNumberOfCells() == 0 || !isSound(surface))
  {
    return list;
  }
  if (polygons->IsHomogeneous() == 3)
  {
    list.triangles.reserve(static_cast<std::size_t>(polygons->GetNumberOfCells()));
    append(list, polygons, nullptr);
    return list;
  }
  vtkNew<vtkIdTypeArray> places;
  places->SetName("polygon");
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    places->InsertNextValue(cell);
  }
  vtkNew<vtkPolyData> alone;
  alone->SetPoints(surface->GetPoints());
  alone->SetPolys(polygons);
  alone->GetCellData()->AddArray(places);
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(alone);
  filter->Update();
  append(
    list, filter->GetOutput()->GetPolys(), filter->GetOutput()->GetCellData()->GetArray("polygon"));
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
