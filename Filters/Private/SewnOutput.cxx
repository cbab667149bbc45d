// SPDX-License-Identifier: BSD-3-Clause
#include "SewnOutput.h"

#include "AttributeArrays.h"
#include "Base/Types.h"
#include "FieldArrays.h"
#include "SurfaceOutput.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
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

void writeShapes(const std::vector<SewnReport>& shapes, vtkFieldData* field)
{
  const auto add = [&](const char* name, auto value) {
    addRows<vtkDoubleArray>(
      field, name, shapes.size(), [&](std::size_t row) { return value(shapes[row]); });
  };
  const auto count = [&](const char* name, auto value) {
    addRows<vtkIdTypeArray>(
      field, name, shapes.size(), [&](std::size_t row) { return value(shapes[row]); });
  };
  const auto measure = [&](const char* name, double SewnMeasures::*member) {
    add(name, [member](const SewnReport& shape) { return shape.measures.*member; });
  };
  count("Pieces", [](const SewnReport& shape) { return shape.pieces; });
  count("Triangles", [](const SewnReport& shape) { return shape.triangles; });
  count("Iterations", [](const SewnReport& shape) { return shape.iterations; });
  addRows<vtkIntArray>(field, "Converged", shapes.size(),
    [&](std::size_t row) { return shapes[row].converged ? 1 : 0; });
  measure("Size", &SewnMeasures::size);
  measure("DistanceMean", &SewnMeasures::distanceMean);
  measure("DistanceRMS", &SewnMeasures::distanceRms);
  measure("DistanceP95", &SewnMeasures::distanceP95);
  measure("DistanceMax", &SewnMeasures::distanceMax);
  const auto share = [&](const char* name, double SewnMeasures::*member) {
    add(name, [member](const SewnReport& shape) {
      return shape.measures.size > 0.0 ? shape.measures.*member / shape.measures.size : 0.0;
    });
  };
  share("RelativeDistanceMean", &SewnMeasures::distanceMean);
  share("RelativeDistanceRMS", &SewnMeasures::distanceRms);
  share("RelativeDistanceP95", &SewnMeasures::distanceP95);
  share("RelativeDistanceMax", &SewnMeasures::distanceMax);
  measure("NormalDeviationMean", &SewnMeasures::normalDeviationMean);
  measure("StrainMean", &SewnMeasures::strainMean);
  measure("StrainP95", &SewnMeasures::strainP95);
  measure("StrainMax", &SewnMeasures::strainMax);
  measure("CompressedArea", &SewnMeasures::compressedArea);
  if (!shapes.empty() && shapes.front().threads)
  {
    add("StrainWarpRms", [](const SewnReport& shape) { return shape.threads->summary.warpRms; });
    add("StrainWeftRms", [](const SewnReport& shape) { return shape.threads->summary.weftRms; });
    add(
      "ShearRms", [](const SewnReport& shape) { return shape.threads->summary.shearRms / degree; });
  }
  add("BodyDepth", [](const SewnReport& shape) { return shape.bodyDepth; });
  add("SecondDistanceMean", [](const SewnReport& shape) { return shape.secondDistance; });
  addRows<vtkIntArray>(field, "SeveralShapes", shapes.size(),
    [&](std::size_t row) { return shapes[row].severalShapes ? 1 : 0; });
  add("MembraneEnergy", [](const SewnReport& shape) { return shape.membraneEnergy; });
  add("BendingEnergy", [](const SewnReport& shape) { return shape.bendingEnergy; });
  std::vector<std::string> names;
  std::vector<std::string> messages;
  for (const SewnReport& shape : shapes)
  {
    names.emplace_back(statusName(shape.status.code));
    messages.push_back(shape.status.message);
  }
  addStrings(field, "Status", names);
  addStrings(field, "StatusMessage", messages);
}

void writeHistory(const std::vector<SewnReport>& shapes, vtkFieldData* field)
{
  std::vector<SewingIteration> rows;
  Indices shapeOfRow;
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    rows.insert(rows.end(), shapes[s].history.begin(), shapes[s].history.end());
    shapeOfRow.resize(rows.size(), static_cast<Index>(s));
  }
  addRows<vtkIdTypeArray>(
    field, "HistoryShape", rows.size(), [&](std::size_t row) { return shapeOfRow[row]; });
  addRows<vtkDoubleArray>(
    field, "HistoryEnergy", rows.size(), [&](std::size_t row) { return rows[row].energy; });
  addRows<vtkDoubleArray>(
    field, "HistoryForce", rows.size(), [&](std::size_t row) { return rows[row].force; });
  addRows<vtkDoubleArray>(
    field, "HistoryMove", rows.size(), [&](std::size_t row) { return rows[row].move; });
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

void writeSewn(vtkPolyData* design, const SewnInput& input, const SewingResult& result,
  vtkPolyData* sewn, vtkPolyData* designed, std::vector<std::string>& warnings)
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
  writeShapes(result.shapes, sewn->GetFieldData());
  writeHistory(result.shapes, sewn->GetFieldData());
  writeSeams(input, result, sewn->GetFieldData());
}
}
}
