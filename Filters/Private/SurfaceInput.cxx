// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceInput.h"

#include "PolyDataSets.h"

#include "vtkPolyData.h"

namespace flattening::bridge
{
Status checkCells(vtkPolyData* surface)
{
  vtkCellArray* const polygons = surface->GetPolys();
  vtkCellArray* const strips = surface->GetStrips();
  if (!polygons->IsValid() || !strips->IsValid())
  {
    return { StatusCode::InvalidPointId,
      "the cells of the surface do not fit the list of their corners; write the file again", {} };
  }
  return checkSize(surface->GetNumberOfPoints(),
    polygons->GetNumberOfConnectivityIds() + strips->GetNumberOfConnectivityIds());
}

SurfaceTriangles readTriangles(vtkPolyData* surface, GhostCells ghosts)
{
  SurfaceTriangles refused;
  refused.outcome = checkCells(surface);
  return refused.outcome.ok() ? flattening::readTriangles(geometryOf(surface), ghosts) : refused;
}

LoadedSurface loadSurface(
  vtkPolyData* surface, CoincidentPoints coincident, Defects defects, GhostCells ghosts)
{
  return flattening::loadSurface(readTriangles(surface, ghosts), coincident, defects);
}

LoadedBody loadBody(vtkPolyData* body)
{
  return body ? flattening::loadBody(readTriangles(body)) : LoadedBody();
}

MappedSurface loadMappedSurface(vtkPolyData* surface, vtkPolyData* flat, vtkPolyData* edges)
{
  MappedSurface refused;
  refused.outcome = checkCells(surface);
  if (refused.outcome.ok() && edges && !edges->GetLines()->IsValid())
  {
    refused.outcome = { StatusCode::InvalidPointId,
      "the lines of the edges do not fit the list of their points", {}, { Remedy::WriteAgain } };
  }
  if (!refused.outcome.ok())
  {
    return refused;
  }
  const DataSet inPlane = flat ? geometryOf(flat) : DataSet();
  const DataSet lines = edges ? geometryOf(edges) : DataSet();
  return flattening::loadMappedSurface(
    geometryOf(surface), flat ? &inPlane : nullptr, edges ? &lines : nullptr);
}
}
