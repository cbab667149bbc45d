// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSewnShape.h"

#include "AttributeArrays.h"
#include "Base/Types.h"
#include "Cut/SurfaceCut.h"
#include "FieldArrays.h"
#include "FilterExecution.h"
#include "Input/ClothInput.h"
#include "Input/StatusWords.h"
#include "ListChanges.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "QualityInput.h"
#include "Report/ReportColumns.h"
#include "Sewing/PieceSewing.h"
#include "SurfaceInput.h"
#include "SurfaceOutput.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

vtkStandardNewMacro(vtkSewnShape);

namespace flattening
{
namespace bridge
{
namespace
{
/// Flat pieces and the cut surface that they are of, with the seams between them.
struct SewnInput
{
  MappedSurface map;
  CutSurface cut; ///< vertices and triangles are those of the map's mesh
  Status outcome;
};

Status invalid(vtkIdType row, const std::string& defect)
{
  return { StatusCode::InvalidOption, "row " + std::to_string(row) + " of SeamPairs " + defect, {},
    { { Remedy::Give, "the flat pieces as they came out of the flattening" } } };
}

/// Finds the two half-edges of a row: from a to b and from d to c, or both the other way round.
bool findPair(const TriangleMesh& mesh, const std::array<Index, 4>& v, SeamPair& pair)
{
  pair.first = mesh.find(v[0], v[1]);
  pair.second = mesh.find(v[3], v[2]);
  if (pair.first == none || pair.second == none)
  {
    pair.first = mesh.find(v[1], v[0]);
    pair.second = mesh.find(v[2], v[3]);
  }
  return pair.first != none && pair.second != none && pair.first != pair.second &&
    mesh.twin(pair.first) == none && mesh.twin(pair.second) == none;
}

Status readSeams(vtkPolyData* flat, const Indices& vertexOfPoint, CutSurface& cut)
{
  vtkDataArray* pairs = flat->GetFieldData()->GetArray("SeamPairs");
  if (!pairs)
  {
    return {};
  }
  if (pairs->GetNumberOfComponents() < 4)
  {
    return invalid(0, "has fewer than 4 components");
  }
  std::vector<char> sewn(cut.mesh.halfedgeCount(), 0);
  for (vtkIdType row = 0; row < pairs->GetNumberOfTuples(); ++row)
  {
    std::array<Index, 4> vertices{};
    for (int k = 0; k < 4; ++k)
    {
      const double id = pairs->GetComponent(row, k);
      if (!(id >= 0.0 && id < static_cast<double>(vertexOfPoint.size())) ||
        vertexOfPoint[static_cast<std::size_t>(id)] == none)
      {
        return invalid(row, "uses a point that is not there");
      }
      vertices[static_cast<std::size_t>(k)] = vertexOfPoint[static_cast<std::size_t>(id)];
    }
    SeamPair pair;
    if (!findPair(cut.mesh, vertices, pair))
    {
      return invalid(row, "is not two edges on the boundaries of pieces");
    }
    if (sewn[pair.first] || sewn[pair.second])
    {
      return invalid(row, "sews an edge that another row sews");
    }
    sewn[pair.first] = sewn[pair.second] = 1;
    if (pairs->GetNumberOfComponents() > 4)
    {
      pair.curve = static_cast<Index>(pairs->GetComponent(row, 4));
    }
    cut.seamPairs.push_back(pair);
  }
  return {};
}

/// \param flat pieces with the field data `SeamPairs`; without it nothing is sewn
/// \param design the cut surface in space, point for point and cell for cell
SewnInput loadSewnInput(vtkPolyData* flat, vtkPolyData* design)
{
  SewnInput result;
  result.map = loadMappedSurface(design, flat, nullptr);
  result.outcome = result.map.outcome;
  if (result.outcome.ok())
  {
    // Without curves this finds the pieces and leaves vertices and triangles as they are.
    result.cut = cutSurface(result.map.surface.prepared.mesh, {});
    result.outcome = result.cut.status;
  }
  if (result.outcome.ok())
  {
    result.outcome = readSeams(flat, result.map.surface.prepared.vertexOfPoint, result.cut);
  }
  return result;
}

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

Columns shapeTable(const std::vector<SewnReport>& shapes)
{
  Columns table;
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
  return table;
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

/// One row per iteration.
Columns sewingIterations(const SewingResult& result)
{
  Columns table;
  const auto rows = numberedElements(result.shapes, &SewnReport::history);
  const TableColumns columns(table, rows);
  columns.add("Shape", [](const auto& row) { return row.first; });
  columns.add("Energy", [](const auto& row) { return row.second.energy; });
  columns.add("Force", [](const auto& row) { return row.second.force; });
  columns.add("Move", [](const auto& row) { return row.second.move; });
  return table;
}

/// Writes what vtkSewnShape documents.
/// \param design the input in space. \param sewn its output 0. \param designed its output 1.
/// \param shapes its output 2
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
  writeTable(shapeTable(result.shapes), shapes);
  writeSeams(input, result, sewn->GetFieldData());
}
}
}
}

//------------------------------------------------------------------------------
vtkSewnShape::vtkSewnShape()
{
  this->SetNumberOfInputPorts(3);
  this->SetTablePort(2);
  this->Iterations = vtkSmartPointer<vtkTable>::New();
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkSewnShape::VisitOptions(flattening::bridge::OptionVisitor& visit)
{
  this->Superclass::VisitOptions(visit);
  visit("Test", this->Test);
  visit("Thickness", this->Thickness);
  visit("AreaBias", this->AreaBias);
  visit("MaximumIterations", this->MaximumIterations);
  visit("Pressure", this->Pressure);
  visit("Gravity", this->Gravity);
  visit("Material", this->Material);
  visit("SecondStart", this->SecondStart);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSewnShape::GetDesignOutput()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
vtkTable* vtkSewnShape::GetShapes()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

//------------------------------------------------------------------------------
vtkTable* vtkSewnShape::GetIterations() const
{
  return this->Iterations;
}

//------------------------------------------------------------------------------
int vtkSewnShape::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSewnShape::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  this->Iterations = vtkSmartPointer<vtkTable>::New();
  vtkPolyData* design = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const flattening::bridge::SewnInput input =
    flattening::bridge::loadSewnInput(vtkPolyData::GetData(inputVector[0]), design);
  const flattening::LoadedBody body =
    flattening::bridge::loadBody(vtkPolyData::GetData(inputVector[2]));
  if (this->Conclude(input.outcome) && this->Conclude(body.outcome))
  {
    flattening::SewingOptions options = this->OptionsForCore().sewing;
    if (!this->Material.empty())
    {
      options.material = flattening::readCloth(this->Material, "").material;
    }
    options.body = body.get();
    const flattening::SewingResult result = flattening::sewPieces(
      input.cut, input.map.positions, options, flattening::bridge::executionOf(this));
    if (this->Conclude(flattening::inInput(result.status, input.map.surface.input.cellOfTriangle)))
    {
      std::vector<std::string> warnings;
      flattening::bridge::writeSewn(design, input, result, output,
        vtkPolyData::GetData(outputVector, 1), vtkTable::GetData(outputVector, 2), warnings);
      this->Iterations =
        flattening::bridge::makeTable(flattening::bridge::sewingIterations(result));
      this->Warn(warnings);
    }
  }
  this->WriteRunStatus(output);
  return 1;
}
