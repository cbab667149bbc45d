// SPDX-License-Identifier: BSD-3-Clause
#include "LocatedSurface.h"

#include "VtkMessages.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>

namespace wirewarp
{
//------------------------------------------------------------------------------
std::array<double, 3> pointOf(vtkPolyData* data, vtkIdType p)
{
  std::array<double, 3> point{};
  data->GetPoint(p, point.data());
  return point;
}

//------------------------------------------------------------------------------
bool canBeLocated(const std::array<double, 3>& point)
{
  constexpr double largest = 1e60; // beyond which the filters refuse coordinates
  return std::all_of(point.begin(), point.end(),
    [](double x) { return std::isfinite(x) && std::abs(x) <= largest; });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> locatedTriangles(vtkPolyData* surface)
{
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    cells->GetCurrentCell(count, ids);
    const bool sound = count > 2 && std::all_of(ids, ids + count, [surface](vtkIdType p) {
      return p >= 0 && p < surface->GetNumberOfPoints() && canBeLocated(pointOf(surface, p));
    });
    if (!sound)
    {
      return nullptr;
    }
  }
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(surface->GetPoints());
  polygons->SetPolys(surface->GetPolys());
  const VtkMessages messages; // of polygons that it cannot divide
  vtkNew<vtkTriangleFilter> division;
  division->SetInputData(polygons);
  division->Update();
  vtkPolyData* const triangles = division->GetOutput();
  return triangles->GetNumberOfCells() > 0 ? triangles : nullptr;
}
}
