// SPDX-License-Identifier: BSD-3-Clause
#include "CurveDistance.h"

#include "LocatedPoint.h"
#include "VtkMessages.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStaticCellLocator.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wirewarp
{
namespace
{
std::array<double, 3> pointOf(vtkPolyData* data, vtkIdType p)
{
  std::array<double, 3> point{};
  data->GetPoint(p, point.data());
  return point;
}

/// Triangles that a locator can be asked about, as the filter divides polygons, since a quad that
/// is not flat has its middle elsewhere: other cells, unsound ids and coordinates are left for the
/// filter.
vtkSmartPointer<vtkPolyData> trianglesOf(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(surface->GetPoints());
  polygons->SetPolys(surface->GetPolys());
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
  const VtkMessages messages; // of polygons that it cannot divide
  vtkNew<vtkTriangleFilter> division;
  division->SetInputData(polygons);
  division->Update();
  vtkPolyData* const triangles = division->GetOutput();
  return triangles->GetNumberOfCells() > 0 ? triangles : nullptr;
}
}

//------------------------------------------------------------------------------
double largestDistance(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves)
{
  double largest = 0.0;
  vtkSmartPointer<vtkPolyData> triangles;
  vtkNew<vtkStaticCellLocator> locator;
  for (vtkPolyData* data : curves)
  {
    if (!data->GetPoints() || data->GetPoints() == surface->GetPoints())
    {
      continue;
    }
    if (!triangles)
    {
      triangles = trianglesOf(surface);
      if (!triangles)
      {
        return 0.0;
      }
      locator->SetDataSet(triangles);
      locator->BuildLocator();
    }
    const auto lines = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
    for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
    {
      const vtkIdType* ids = nullptr;
      vtkIdType count = 0;
      lines->GetCurrentCell(count, ids);
      for (vtkIdType k = 0; k < count; ++k)
      {
        if (ids[k] < 0 || ids[k] >= data->GetNumberOfPoints())
        {
          continue;
        }
        const std::array<double, 3> x = pointOf(data, ids[k]);
        std::array<double, 3> closest{};
        vtkIdType cell = -1;
        int part = 0;
        double square = 0.0;
        if (canBeLocated(x))
        {
          locator->FindClosestPoint(x.data(), closest.data(), cell, part, square);
          largest = cell >= 0 ? std::max(largest, std::sqrt(square)) : largest;
        }
      }
    }
  }
  return largest;
}
}
