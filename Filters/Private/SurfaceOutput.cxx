// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOutput.h"

#include "AttributeArrays.h"
#include "Report/FlatteningData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace flattening::bridge
{
namespace
{
void copyPointData(const CurvedPolyData& source, const Indices& originalVertex, vtkPolyData* output)
{
  vtkPointData* from = source.pointArrays;
  vtkPointData* to = output->GetPointData();
  const Index count = static_cast<Index>(originalVertex.size());
  to->CopyGlobalIdsOff(); // a copy of a point would have the id of another
  to->InterpolateAllocate(from, count);
  vtkNew<vtkIdList> sourcePoints;
  double weights[3];
  const bool any = from->GetNumberOfArrays() > 0;
  for (Index v = 0; any && v < count; ++v)
  {
    const Index vertex = originalVertex[v];
    const vtkIdType point = source.pointOf(vertex);
    if (point >= 0)
    {
      to->CopyData(from, point, v);
      continue;
    }
    const VertexSource& mean = source.imprinted.vertexSource[vertex];
    sourcePoints->Reset();
    for (int k = 0; k < 3; ++k)
    {
      if (mean.vertices[k] != none && mean.weights[k] != 0.0)
      {
        weights[sourcePoints->GetNumberOfIds()] = mean.weights[k];
        sourcePoints->InsertNextId(source.surface.prepared.originalPoint[mean.vertices[k]]);
      }
    }
    to->InterpolatePoint(from, v, sourcePoints, weights);
  }
}

/// Triangles over points, each a copy of a vertex of the imprinted surface, with the input's data.
void writeSurface(const CurvedPolyData& source, const Triangles& triangles,
  const std::vector<std::int64_t>& cellOfTriangle, const Indices& originalVertex, vtkPoints* points,
  vtkPolyData* output)
{
  output->SetPoints(points);
  output->SetPolys(makeTriangles(triangles));
  copyPointData(source, originalVertex, output);
  copyCellData(source.cellArrays, cellOfTriangle, output);
  output->GetFieldData()->PassData(source.fieldData);
}

/// The cell arrays that all data sets of the curves have.
void copyCurveData(
  const CurvedPolyData& source, vtkCellData* cells, std::vector<std::string>& warnings)
{
  std::vector<vtkPolyData*> sources;
  std::vector<vtkSmartPointer<vtkCellData>> arrays;
  std::vector<int> sourceOfCurve;
  const CurveInput& curves = source.curves;
  for (const int number : curves.sourceOfPolyline)
  {
    vtkPolyData* const data = source.sources[static_cast<std::size_t>(number)];
    const auto known = std::find(sources.begin(), sources.end(), data);
    sourceOfCurve.push_back(static_cast<int>(known - sources.begin()));
    if (known == sources.end())
    {
      sources.push_back(data);
      arrays.push_back(wholeCellArrays(data, warnings));
    }
  }
  vtkDataSetAttributes::FieldList common(static_cast<int>(sources.size()));
  for (std::size_t s = 0; s < sources.size(); ++s)
  {
    s == 0 ? common.InitializeFieldList(arrays[s]) : common.IntersectFieldList(arrays[s]);
  }
  const vtkIdType count = static_cast<vtkIdType>(curves.cellOfPolyline.size());
  cells->CopyGlobalIdsOff(); // a curve can be joined from several cells
  cells->CopyAllocate(common, count);
  for (vtkIdType c = 0; c < count; ++c)
  {
    cells->CopyData(
      common, arrays[sourceOfCurve[c]], sourceOfCurve[c], curves.cellOfPolyline[c], c);
  }
}

/// The flat positions as active texture coordinates; those of the input stay among the point data.
void writeTextureCoordinates(const Points2& positions, vtkPointData* points)
{
  std::vector<double> coordinates;
  for (const Point2& position : positions)
  {
    coordinates.insert(coordinates.end(), { position.x(), position.y() });
  }
  addColumns(points, { { "FlatPositions", std::move(coordinates), 2 } });
  points->SetActiveTCoords("FlatPositions");
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

void copyCellData(
  vtkCellData* input, const std::vector<std::int64_t>& cellOfTriangle, vtkPolyData* output)
{
  vtkCellData* cells = output->GetCellData();
  cells->CopyGlobalIdsOff(); // a triangle can be one of several of its cell
  cells->CopyAllocate(input, static_cast<vtkIdType>(cellOfTriangle.size()));
  const bool any = input->GetNumberOfArrays() > 0;
  for (std::size_t t = 0; any && t < cellOfTriangle.size(); ++t)
  {
    cells->CopyData(input, cellOfTriangle[t], static_cast<vtkIdType>(t));
  }
  addColumns(cells, { { "vtkOriginalCellIds", cellOfTriangle } });
}

void writeImprint(const CurvedPolyData& source, vtkPolyData* surface, vtkPolyData* curves,
  std::vector<std::string>& warnings)
{
  const ImprintData made = imprintData({}, source);
  const TriangleMesh& mesh = source.imprinted.mesh;
  // The first array is vtkOriginalCellIds, also below.
  const auto& cells = std::get<std::vector<std::int64_t>>(made.surface.cellArrays.front().values);
  Indices vertices(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(vertices.begin(), vertices.end(), 0);
  writeSurface(source, mesh.triangles(), cells, vertices, makePoints(mesh.points()), surface);
  addColumns(surface->GetPointData(), made.surface.pointArrays);
  const DataSet& data = made.curves;
  curves->SetPoints(surface->GetPoints());
  curves->SetLines(makeCells(data.lines));
  curves->GetPointData()->ShallowCopy(surface->GetPointData());
  addColumns(curves->GetPointData(), data.pointArrays);
  if (data.lines.size() > 0)
  {
    copyCurveData(source, curves->GetCellData(), warnings);
  }
  addColumns(curves->GetCellData(), data.cellArrays);
}

void writeCutSurface(const CurvedPolyData& source, const CutSurface& cut, const CutArrays& arrays,
  vtkPoints* points, vtkPolyData* output)
{
  const auto& cells = std::get<std::vector<std::int64_t>>(arrays.cellArrays.front().values);
  writeSurface(source, cut.mesh.triangles(), cells, arrays.originalVertex, points, output);
  addColumns(output->GetPointData(), arrays.pointArrays);
  addColumns(output->GetCellData(), arrays.cellArrays);
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
