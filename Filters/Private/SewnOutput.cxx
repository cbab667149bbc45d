// SPDX-License-Identifier: BSD-3-Clause
#include "SewnOutput.h"

#include "AttributeArrays.h"
#include "Base/Types.h"
#include "SurfaceOutput.h"
#include "TableColumns.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace flattening
{
namespace bridge
{
namespace
{
/// Points of the input moved to where the vertices lie.
vtkSmartPointer<vtkPoints> movedPoints(
  vtkPolyData* design, const Indices& originalPoint, const Points3& points)
{
  auto moved = vtkSmartPointer<vtkPoints>::New();
  moved->SetDataTypeToDouble();
  moved->DeepCopy(design->GetPoints());
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    moved->SetPoint(originalPoint[v], points[v].data());
  }
  return moved;
}

void addPointArray(vtkPolyData* output, const char* name, const Indices& vertexOfPoint,
  const std::vector<double>& ofVertex)
{
  addRows<vtkDoubleArray>(
    output->GetPointData(), name, vertexOfPoint.size(), [&](std::size_t point) {
      const Index vertex = vertexOfPoint[point];
      return vertex == none ? 0.0 : ofVertex[vertex];
    });
}

void writeCells(const SewingResult& result, vtkPolyData* output)
{
  vtkCellData* cells = output->GetCellData();
  const std::size_t count = result.shapeOfTriangle.size();
  addRows<vtkIdTypeArray>(
    cells, "ShapeId", count, [&](std::size_t t) { return result.shapeOfTriangle[t]; });
  addRows<vtkDoubleArray>(
    cells, "NormalDeviation", count, [&](std::size_t t) { return result.normalDeviation[t]; });
  vtkNew<vtkDoubleArray> strains;
  strains->SetName("PrincipalStrains");
  strains->SetNumberOfComponents(2);
  strains->SetNumberOfTuples(static_cast<vtkIdType>(count));
  for (std::size_t t = 0; t < count; ++t)
  {
    const double row[2] = { result.stretches[t][0] - 1.0, result.stretches[t][1] - 1.0 };
    strains->SetTypedTuple(static_cast<vtkIdType>(t), row);
  }
  cells->AddArray(strains);
  addRows<vtkUnsignedCharArray>(cells, "Compressed", count, [&](std::size_t t) {
    return static_cast<unsigned char>(isCompressed(result.stretches[t]) ? 1 : 0);
  });
  const auto ofThreads = [&](const char* name, auto value) {
    if (!result.threads.empty())
    {
      addRows<vtkDoubleArray>(
        cells, name, count, [&](std::size_t t) { return value(result.threads[t]); });
    }
  };
  ofThreads("SewnStrainWarp", [](const ThreadStrain& strain) { return strain.warp; });
  ofThreads("SewnStrainWeft", [](const ThreadStrain& strain) { return strain.weft; });
  ofThreads("SewnShearAngle", [](const ThreadStrain& strain) { return strain.shear / degree; });
}

void writeShapes(const std::vector<SewnReport>& shapes, vtkTable* table)
{
  const TableColumns<SewnReport> columns(table, shapes);
  using Shape = const SewnReport&;
  const auto measure = [&columns](const char* name, double SewnMeasures::*member) {
    columns.add(name, [member](Shape shape) { return shape.measures.*member; });
  };
  const auto share = [&columns](const char* name, double SewnMeasures::*member) {
    columns.add(name, [member](Shape shape) {
      return shape.measures.size > 0.0 ? shape.measures.*member / shape.measures.size : 0.0;
    });
  };
  columns.addNumbers("Shape");
  columns.add("Status", [](Shape shape) { return statusName(shape.status.code); });
  columns.add("Pieces", &SewnReport::pieces);
  measure("Size", &SewnMeasures::size);
  measure("DistanceMean", &SewnMeasures::distanceMean);
  measure("DistanceRms", &SewnMeasures::distanceRms);
  measure("DistanceP95", &SewnMeasures::distanceP95);
  measure("DistanceMax", &SewnMeasures::distanceMax);
  share("RelativeDistanceMean", &SewnMeasures::distanceMean);
  share("RelativeDistanceRms", &SewnMeasures::distanceRms);
  share("RelativeDistanceP95", &SewnMeasures::distanceP95);
  share("RelativeDistanceMax", &SewnMeasures::distanceMax);
  measure("NormalDeviationMean", &SewnMeasures::normalDeviationMean);
  measure("StrainMean", &SewnMeasures::strainMean);
  measure("StrainP95", &SewnMeasures::strainP95);
  measure("StrainMax", &SewnMeasures::strainMax);
  measure("CompressedArea", &SewnMeasures::compressedArea);
  if (!shapes.empty() && shapes.front().threads)
  {
    columns.add("StrainWarpRms", [](Shape shape) { return shape.threads->summary.warpRms; });
    columns.add("StrainWeftRms", [](Shape shape) { return shape.threads->summary.weftRms; });
    columns.add("ShearRms", [](Shape shape) { return shape.threads->summary.shearRms / degree; });
  }
  columns.add("BodyDepth", &SewnReport::bodyDepth);
  columns.add("SecondDistanceMean", &SewnReport::secondDistance);
  columns.add("SeveralShapes", &SewnReport::severalShapes);
  columns.add("MembraneEnergy", &SewnReport::membraneEnergy);
  columns.add("BendingEnergy", &SewnReport::bendingEnergy);
  columns.add("Triangles", &SewnReport::triangles);
  columns.add("Iterations", &SewnReport::iterations);
  columns.add("Converged", &SewnReport::converged);
  columns.add("StatusMessage", [](Shape shape) { return shape.status.message; });
}

void writeSeams(const SewnInput& input, const SewingResult& result, vtkFieldData* field)
{
  const TriangleMesh& mesh = input.cut.mesh;
  const Indices& pointOf = input.map.surface.prepared.originalPoint;
  vtkNew<vtkIdTypeArray> pairs;
  pairs->SetName("SeamPairs");
  pairs->SetNumberOfComponents(5);
  vtkNew<vtkDoubleArray> strains;
  strains->SetName("SeamStrains");
  strains->SetNumberOfComponents(2);
  for (std::size_t k = 0; k < input.cut.seamPairs.size(); ++k)
  {
    const SeamPair& pair = input.cut.seamPairs[k];
    const vtkIdType row[5] = { pointOf[mesh.from(pair.first)], pointOf[mesh.to(pair.first)],
      pointOf[mesh.to(pair.second)], pointOf[mesh.from(pair.second)], pair.curve };
    pairs->InsertNextTypedTuple(row);
    strains->InsertNextTypedTuple(result.seamStrain[k].data());
  }
  addUnlessEmpty(field, pairs);
  addUnlessEmpty(field, strains);
}

/// Sentences on shapes that are not the only ones, or not where they should be.
void describeShapes(const std::vector<SewnReport>& shapes, std::vector<std::string>& warnings)
{
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    const SewnReport& shape = shapes[s];
    const std::string cloth =
      shapes.size() == 1 ? "the cloth" : "the cloth of ShapeId " + std::to_string(s);
    if (shape.severalShapes)
    {
      warnings.push_back(cloth +
        " buckles and has several shapes at rest: from a second start it lies " +
        shortNumber(shape.secondDistance) + " from the design in the mean, not " +
        shortNumber(shape.measures.distanceMean));
    }
    if (shape.bodyDepth > 0.0)
    {
      warnings.push_back(cloth + " lies " + shortNumber(shape.bodyDepth) +
        " deep in the body; see that the body's normals point outwards and the design is not "
        "inside");
    }
  }
}
}

vtkSmartPointer<vtkTable> sewingIterations(const SewingResult& result)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  const auto rows = numberedElements(result.shapes, &SewnReport::history);
  const TableColumns columns(table, rows);
  columns.add("Shape", [](const auto& row) { return row.first; });
  columns.add("Energy", [](const auto& row) { return row.second.energy; });
  columns.add("Force", [](const auto& row) { return row.second.force; });
  columns.add("Move", [](const auto& row) { return row.second.move; });
  return table;
}

void writeSewn(vtkPolyData* design, const SewnInput& input, const SewingResult& result,
  vtkPolyData* sewn, vtkPolyData* designed, vtkTable* shapes, std::vector<std::string>& warnings)
{
  const LoadedSurface& surface = input.map.surface;
  const auto pointArrays = wholePointArrays(design, warnings);
  const auto cellArrays = wholeCellArrays(design, warnings);
  for (vtkPolyData* output : { sewn, designed })
  {
    output->SetPolys(makeTriangles(surface.input.triangles));
    output->GetPointData()->ShallowCopy(pointArrays);
    copyCellData(cellArrays, surface.input.cellOfTriangle, output);
    writeCells(result, output);
  }
  // Normals are those of the design.
  sewn->GetPointData()->SetNormals(nullptr);
  sewn->SetPoints(movedPoints(design, surface.prepared.originalPoint, result.points));
  designed->SetPoints(design->GetPoints());
  addPointArray(sewn, "Distance", surface.prepared.vertexOfPoint, result.distance);
  addPointArray(designed, "Distance", surface.prepared.vertexOfPoint, result.designDistance);
  for (vtkPolyData* output : { sewn, designed })
  {
    output->GetPointData()->SetActiveScalars("Distance");
  }
  describeShapes(result.shapes, warnings);
  writeShapes(result.shapes, shapes);
  writeSeams(input, result, sewn->GetFieldData());
}
}
}
