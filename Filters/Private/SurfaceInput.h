// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outcome.h"
#include "Surface/SurfacePreparation.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// The polygons and strips of a vtkPolyData as triangles over all of its points.
struct SurfaceTriangles
{
  Points3 points;
  Triangles triangles; ///< those of one cell in a row, cells in order
  std::vector<vtkIdType> cellOfTriangle;
  Outcome outcome;
};

SurfaceTriangles readTriangles(vtkPolyData* surface);

/// A surface read and made into a mesh, or refused in the ids of the input.
struct LoadedSurface
{
  SurfaceTriangles input;
  PreparedSurface prepared;
  Outcome outcome;
};

LoadedSurface loadSurface(vtkPolyData* surface, CoincidentPoints coincident);
}
}
