// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceInput.h"

#include "Base/Types.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace flattening
{
namespace bridge
{
namespace
{
void appendTriangle(SurfaceTriangles& result, vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
{
  result.triangles.push_back({ pointIndex(a), pointIndex(b), pointIndex(c) });
  result.cellOfTriangle.push_back(cell);
}

/// True where every point of every cell exists and is finite, so that geometry can be computed.
bool isSound(const SurfaceTriangles& result, vtkCellArray* cells)
{
  bool sound = true;
  const vtkIdType pointCount = static_cast<vtkIdType>(result.points.size());
  forEachCell(cells, [&](vtkIdType, vtkIdType count, const vtkIdType* ids) {
    sound = sound && std::all_of(ids, ids + count, [&](vtkIdType id) {
      return id >= 0 && id < pointCount && isFinite(result.points[id]);
    });
  });
  return sound;
}

void triangulate(
  SurfaceTriangles& result, vtkPolyData* surface, const CellChoice& choice, vtkIdType firstCell)
{
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(surface->GetPoints());
  polygons->SetPolys(surface->GetPolys());
  polygons->SetStrips(surface->GetStrips());
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName("cell");
  for (vtkIdType k = 0; k < polygons->GetNumberOfCells(); ++k)
  {
    cellIds->InsertNextValue(k);
  }
  polygons->GetCellData()->AddArray(cellIds);

  vtkNew<vtkTriangleFilter> triangulation;
  triangulation->PassVertsOff();
  triangulation->PassLinesOff();
  triangulation->SetInputData(polygons);
  // Its warnings are of polygons that are divided below.
  triangulation->AddObserver(vtkCommand::WarningEvent, vtkSmartPointer<vtkCallbackCommand>::New());
  triangulation->Update();
  vtkPolyData* triangles = triangulation->GetOutput();
  auto* origin = vtkIdTypeArray::SafeDownCast(triangles->GetCellData()->GetArray("cell"));
  Triangles divided; // in the order of their polygons
  std::vector<vtkIdType> polygonOf;
  forEachCell(triangles->GetPolys(), [&](vtkIdType k, vtkIdType count, const vtkIdType* ids) {
    // VTK 9.6 hands on a polygon of two points.
    if (count == 3)
    {
      divided.push_back({ pointIndex(ids[0]), pointIndex(ids[1]), pointIndex(ids[2]) });
      polygonOf.push_back(origin->GetValue(k));
    }
  });

  std::vector<std::int64_t> lost;
  std::size_t next = 0;
  const auto append = [&](vtkIdType k, const Indices& corners) {
    Triangles proposed;
    for (; next < divided.size() && polygonOf[next] == k; ++next)
    {
      proposed.push_back(divided[next]);
    }
    if (choice.reads(firstCell + k) && !appendPolygon(result, firstCell + k, corners, proposed))
    {
      lost.push_back(firstCell + k);
    }
  };
  forEachCell(polygons->GetPolys(), [&](vtkIdType k, vtkIdType count, const vtkIdType* ids) {
    append(k, Indices(ids, ids + count));
  });
  for (vtkIdType k = polygons->GetNumberOfPolys(); k < polygons->GetNumberOfCells(); ++k)
  {
    append(k, {}); // a strip
  }
  result.outcome = refuseLost(lost);
}
}

CellChoice::CellChoice(vtkPolyData* data, GhostCells ghosts)
  : Ghosts(vtkUnsignedCharArray::SafeDownCast(
      data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName())))
  , LeftOut(ghosts == GhostCells::LeftOut
        ? vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL
        : vtkDataSetAttributes::HIDDENCELL)
{
  if (this->Ghosts && this->Ghosts->GetNumberOfValues() < data->GetNumberOfCells())
  {
    this->Ghosts = nullptr; // too short, as wholeCellArrays() tells
  }
}

bool CellChoice::reads(vtkIdType cell) const
{
  return !this->Ghosts || (this->Ghosts->GetValue(cell) & this->LeftOut) == 0;
}

SurfaceTriangles readTriangles(vtkPolyData* surface, GhostCells ghosts)
{
  SurfaceTriangles result;
  vtkCellArray* polygons = surface->GetPolys();
  vtkCellArray* strips = surface->GetStrips();
  if (!polygons->IsValid() || !strips->IsValid())
  {
    result.outcome = { StatusCode::InvalidPointId,
      "the cells of the surface do not fit the list of their corners; write the file again", {} };
    return result;
  }
  const CellChoice choice(surface, ghosts);
  const vtkIdType firstCell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const vtkIdType corners =
    polygons->GetNumberOfConnectivityIds() + strips->GetNumberOfConnectivityIds();
  result.outcome = checkSize(surface->GetNumberOfPoints(), corners);
  if (!result.outcome.ok())
  {
    return result;
  }

  result.points.resize(surface->GetNumberOfPoints());
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    surface->GetPoint(p, result.points[p].data());
  }
  result.triangles.reserve(corners / 3);
  result.cellOfTriangle.reserve(corners / 3);

  const bool trianglesOnly = strips->GetNumberOfCells() == 0 &&
    (polygons->GetNumberOfCells() == 0 || polygons->IsHomogeneous() == 3);
  if (!trianglesOnly && isSound(result, polygons) && isSound(result, strips))
  {
    triangulate(result, surface, choice, firstCell);
    return result;
  }
  // Triangles as they are; or fans, which keep the unsound points for prepareSurface() to refuse.
  forEachCell(polygons, [&](vtkIdType k, vtkIdType count, const vtkIdType* ids) {
    for (vtkIdType i = 2; i < count && choice.reads(firstCell + k); ++i)
    {
      appendTriangle(result, firstCell + k, ids[0], ids[i - 1], ids[i]);
    }
  });
  const vtkIdType firstStrip = firstCell + polygons->GetNumberOfCells();
  forEachCell(strips, [&](vtkIdType k, vtkIdType count, const vtkIdType* ids) {
    for (vtkIdType i = 2; i < count && choice.reads(firstStrip + k); ++i)
    {
      appendTriangle(result, firstStrip + k, ids[i - 2], ids[i - 1], ids[i]);
    }
  });
  return result;
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
}
}
