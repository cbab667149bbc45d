// SPDX-License-Identifier: BSD-3-Clause
#include "QualityOutput.h"

#include "AttributeArrays.h"

#include "Quality/BoundaryOverlap.h"
#include "Quality/SurfaceDevelopability.h"
#include "SurfaceOutput.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace flattening
{
namespace bridge
{
namespace
{
void writeOverlapEdges(
  const MappedSurface& map, const std::vector<std::array<Index, 2>>& overlaps, vtkFieldData* field)
{
  const TriangleMesh& mesh = map.surface.prepared.mesh;
  const Indices& pointOf = map.surface.prepared.originalPoint;
  vtkNew<vtkIdTypeArray> edges;
  edges->SetName("OverlapEdges");
  edges->SetNumberOfComponents(4);
  for (const std::array<Index, 2>& pair : overlaps)
  {
    const vtkIdType row[4] = { pointOf[mesh.from(pair[0])], pointOf[mesh.to(pair[0])],
      pointOf[mesh.from(pair[1])], pointOf[mesh.to(pair[1])] };
    edges->InsertNextTypedTuple(row);
  }
  addUnlessEmpty(field, edges);
}
}

void writeQuality(vtkPolyData* input, const MappedSurface& map, std::size_t mostListedOverlaps,
  const Execution& execution, vtkPolyData* output, std::vector<std::string>& warnings)
{
  const TriangleMesh& mesh = map.surface.prepared.mesh;
  const FlatteningQuality quality = measureFlattening(mesh, map.positions, map.edges, execution);
  const BoundaryOverlaps overlaps = countBoundaryOverlaps(mesh, map.positions, mostListedOverlaps);

  if (!map.surface.loosePoints.empty())
  {
    warnings.push_back(leftOut(map.surface));
  }
  output->SetPoints(input->GetPoints());
  output->SetPolys(makeTriangles(map.surface.input.triangles));
  output->GetPointData()->ShallowCopy(wholePointArrays(input, warnings));
  copyCellData(wholeCellArrays(input, warnings), map.surface.input.cellOfTriangle, output);
  writeTriangleQuality(quality.triangles, output);

  vtkFieldData* field = output->GetFieldData();
  field->PassData(fieldArrays(input, warnings));
  auto addCount = [field](const char* name, vtkIdType count) {
    addRows<vtkIdTypeArray>(field, name, 1, [count](std::size_t) { return count; });
  };
  addCount("Triangles", mesh.triangleCount());
  addCount("Vertices", mesh.vertexCount());
  addCount("Overlaps", static_cast<vtkIdType>(overlaps.count));
  addRows<vtkIntArray>(
    field, "OverlapsComplete", 1, [&overlaps](std::size_t) { return overlaps.complete ? 1 : 0; });
  addCount("Mirrored", map.mirrored ? 1 : 0);
  writeSummaries({ quality.summary }, field);
  addRows<vtkDoubleArray>(field, "CutLength", 1, [&mesh](std::size_t) { return cutLength(mesh); });
  writeOverlapEdges(map, overlaps.listed, field);
}
}
}
