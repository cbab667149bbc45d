// SPDX-License-Identifier: BSD-3-Clause
// A bulging sheet over the unit square.
#pragma once

#include "LiveFlattening.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <cmath>

namespace sheets
{
inline double bulge(double x, double y)
{
  return 0.1 * std::sin(3.0 * x) * std::sin(3.0 * y);
}

/// \param squares on a side
inline figures::PolyData sheet(int squares)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= squares; ++j)
  {
    for (int i = 0; i <= squares; ++i)
    {
      const double x = static_cast<double>(i) / squares;
      const double y = static_cast<double>(j) / squares;
      const vtkIdType a = points->InsertNextPoint(x, y, bulge(x, y));
      const vtkIdType b = a + squares + 1;
      if (i < squares && j < squares)
      {
        triangles->InsertNextCell({ a, a + 1, b + 1 });
        triangles->InsertNextCell({ a, b + 1, b });
      }
    }
  }
  figures::PolyData data = figures::PolyData::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}
}
