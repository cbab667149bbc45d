// SPDX-License-Identifier: BSD-3-Clause
#include "Report/QualityReport.h"

#include "Base/Types.h"
#include "Quality/BoundaryOverlap.h"
#include "Quality/FlatteningQuality.h"
#include "Report/FlatteningArrays.h"
#include "Report/FlatteningTables.h"

#include <array>
#include <utility>

namespace flattening
{
QualityReport reportQuality(const MappedSurface& map, std::size_t most, const Execution& execution)
{
  const TriangleMesh& mesh = map.surface.prepared.mesh;
  const FlatteningQuality quality = measureFlattening(mesh, map.positions, map.edges, execution);
  const BoundaryOverlaps overlaps = countBoundaryOverlaps(mesh, map.positions, most);
  QualityReport report;
  addTriangleQuality(quality.triangles, report.cells);

  const Indices& pointOf = map.surface.prepared.originalPoint;
  std::vector<std::int64_t> edges;
  for (const std::array<Index, 2>& pair : overlaps.listed)
  {
    for (const Index h : pair)
    {
      edges.push_back(pointOf[mesh.from(h)]);
      edges.push_back(pointOf[mesh.to(h)]);
    }
  }
  report.overlapEdges = { "OverlapEdges", std::move(edges), 4 };

  const std::vector<QualitySummary> rows{ quality.summary };
  const TableColumns<QualitySummary> columns(report.measures, rows);
  using Summary = const QualitySummary&;
  addSummaries(columns, [](Summary summary) -> Summary { return summary; });
  columns.add("Overlaps", [&overlaps](Summary) { return overlaps.count; });
  columns.add("OverlapsComplete", [&overlaps](Summary) { return overlaps.complete; });
  columns.add("CutLength", [&mesh](Summary) { return cutLength(mesh); });
  columns.add("Triangles", [&mesh](Summary) { return mesh.triangleCount(); });
  columns.add("Vertices", [&mesh](Summary) { return mesh.vertexCount(); });
  columns.add("Mirrored", [&map](Summary) { return map.mirrored; });
  return report;
}

Column developabilityOfPoints(const LoadedSurface& surface, const Execution& execution)
{
  const TriangleMesh& mesh = surface.prepared.mesh;
  const std::vector<double> ofVertices = surfaceDevelopability(mesh, cornerAngles(mesh, execution));
  std::vector<double> values;
  for (const Index vertex : surface.prepared.vertexOfPoint)
  {
    values.push_back(vertex == none ? 0.0 : ofVertices[static_cast<std::size_t>(vertex)]);
  }
  return { "Developability", std::move(values) };
}
}
