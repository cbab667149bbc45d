// SPDX-License-Identifier: BSD-3-Clause
#include "FlatteningOutput.h"

#include "AttributeArrays.h"
#include "Base/Types.h"
#include "Report/FlatteningArrays.h"
#include "SurfaceOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace flattening::bridge
{
namespace
{
/// The flat positions as active texture coordinates; those of the input stay among the point data.
void writeTextureCoordinates(const Points2& positions, vtkPointData* points)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetName("FlatPositions");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(positions.size()));
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    coordinates->SetTypedTuple(static_cast<vtkIdType>(v), positions[v].data());
  }
  points->AddArray(coordinates);
  points->SetActiveTCoords(coordinates->GetName());
}

/// What viewers color by until the user chooses; what the input chose stays.
void setActiveScalars(vtkPolyData* data, const char* name)
{
  if (!data->GetPointData()->GetScalars() && !data->GetCellData()->GetScalars())
  {
    data->GetCellData()->SetActiveScalars(name);
  }
}

/// Normals and tangents of the surface in space, which would shade the flat pieces by its shape.
void dropDirections(vtkDataSetAttributes* arrays)
{
  for (const int attribute : { vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TANGENTS })
  {
    int place[vtkDataSetAttributes::NUM_ATTRIBUTES];
    arrays->GetAttributeIndices(place);
    if (place[attribute] >= 0)
    {
      arrays->RemoveArray(place[attribute]);
    }
  }
}
}

void writeWires(
  const std::vector<Wire>& wires, const Columns& arrays, vtkPolyData* surface, vtkPolyData* output)
{
  vtkNew<vtkCellArray> lines;
  for (const Wire& wire : wires)
  {
    lines->InsertNextCell(static_cast<int>(wire.vertices.size()));
    for (const Index v : wire.vertices)
    {
      lines->InsertCellPoint(v);
    }
  }
  output->SetPoints(surface->GetPoints());
  output->SetLines(lines);
  output->GetPointData()->ShallowCopy(surface->GetPointData());
  addColumns(output->GetCellData(), arrays);
}

void writeFlattening(const CurvedPolyData& source, const FlatteningResult& result,
  const FlatteningOptions& options, vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut)
{
  const FlatteningArrays arrays = flatteningArrays(source, result, options);
  writeCutSurface(source, *result.cut, arrays, makePoints(arrays.positions), flat);
  setActiveScalars(flat, "HomogeneityOfDistortion");

  // In space the same data over the original points.
  cut->SetPoints(makePoints(arrays.points));
  cut->SetPolys(flat->GetPolys());
  cut->GetPointData()->ShallowCopy(flat->GetPointData());
  cut->GetCellData()->ShallowCopy(flat->GetCellData());
  writeTextureCoordinates(arrays.positions, cut->GetPointData());
  dropDirections(flat->GetPointData());
  dropDirections(flat->GetCellData());

  writeWires(result.wires, arrays.wireArrays, flat, wires);
  setActiveScalars(wires, "WireKind");
  addColumns(flat->GetFieldData(), arrays.fieldArrays);
}
}
