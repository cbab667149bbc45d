// SPDX-License-Identifier: BSD-3-Clause
#include "CurveDistance.h"

#include "LocatedPoint.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStaticCellLocator.h>

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

/// Data that a locator can be asked about: other cells, unsound ids and coordinates are left for
/// the filter.
vtkSmartPointer<vtkPolyData> polygonsOf(vtkPolyData* surface)
{
  auto polygons = vtkSmartPointer<vtkPolyData>::New();
  polygons->SetPoints(surface->GetPoints());
  polygons->SetPolys(surface->GetPolys());
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    cells->GetCurrentCell(count, ids);
    const bool sound = std::all_of(ids, ids + count, [surface](vtkIdType p) {
      return p >= 0 && p < surface->GetNumberOfPoints() && canBeLocated(pointOf(surface, p));
    });
    if (!sound)
    {
      return nullptr;
    }
  }
  return polygons->GetNumberOfCells() > 0 ? polygons : nullptr;
}
}

//------------------------------------------------------------------------------
double largestDistance(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves)
{
  double largest = 0.0;
  vtkSmartPointer<vtkPolyData> polygons;
  vtkNew<vtkStaticCellLocator> locator;
  for (vtkPolyData* data : curves)
  {
    if (!data->GetPoints() || data->GetPoints() == surface->GetPoints())
    {
      continue;
    }
    if (!polygons)
    {
      polygons = polygonsOf(surface);
      if (!polygons)
      {
        return 0.0;
      }
      locator->SetDataSet(polygons);
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
