// SPDX-License-Identifier: BSD-3-Clause
#include "QualityOutput.h"

#include "AttributeArrays.h"

#include "Quality/BoundaryOverlap.h"
#include "Quality/SurfaceDevelopability.h"
#include "SurfaceOutput.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
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
  const Execution& execution, vtkPolyData* output, vtkTable* measures,
  std::vector<std::string>& warnings)
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
  writeOverlapEdges(map, overlaps.listed, field);

  const std::vector<QualitySummary> rows{ quality.summary };
  const TableColumns<QualitySummary> columns(measures, rows);
  using Summary = const QualitySummary&;
  addSummaries(columns, [](Summary summary) -> Summary { return summary; });
  columns.add("Overlaps", [&overlaps](Summary) { return overlaps.count; });
  columns.add("OverlapsComplete", [&overlaps](Summary) { return overlaps.complete; });
  columns.add("CutLength", [&mesh](Summary) { return cutLength(mesh); });
  columns.add("Triangles", [&mesh](Summary) { return mesh.triangleCount(); });
  columns.add("Vertices", [&mesh](Summary) { return mesh.vertexCount(); });
  columns.add("Mirrored", [&map](Summary) { return map.mirrored; });
}
}
}
