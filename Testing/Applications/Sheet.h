// SPDX-License-Identifier: BSD-3-Clause
// A bulging sheet over the unit square.
#pragma once

#include "LiveFlattening.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace sheets
{
/// Flattens and waits for the pieces. \return whether there are any
inline bool run(
  editor::LiveFlattening& live, vtkPolyData* curves, editor::Care care = editor::Care::Full)
{
  live.ask(curves, care);
  while (live.isBusy())
  {
    live.take();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return !live.isRefused();
}

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
