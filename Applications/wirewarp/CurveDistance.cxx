// SPDX-License-Identifier: BSD-3-Clause
#include "CurveDistance.h"

#include "LocatedSurface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wirewarp
{
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
      triangles = locatedTriangles(surface);
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
