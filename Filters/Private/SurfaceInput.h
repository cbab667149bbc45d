// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"
#include "Input/MappedSurface.h"
#include "Surface/SurfacePreparation.h"

class vtkPolyData;

namespace flattening::bridge
{
/// Whether the polygons and strips can be read.
Status checkCells(vtkPolyData* surface);

/// The polygons and strips, but ghost cells.
SurfaceTriangles readTriangles(vtkPolyData* surface, GhostCells ghosts = GhostCells::LeftOut);

LoadedSurface loadSurface(vtkPolyData* surface, CoincidentPoints coincident, Defects defects,
  GhostCells ghosts = GhostCells::LeftOut);

/// Reads a body; null: there is none.
LoadedBody loadBody(vtkPolyData* body);

/// As the function of Core; data sets may be null.
MappedSurface loadMappedSurface(vtkPolyData* surface, vtkPolyData* flat, vtkPolyData* edges);
}
