// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlatPieceAlgorithm.h"

#include "AttributeArrays.h"
#include "CurvedPolyData.h"
#include "Distribution.h"
#include "FilterExecution.h"
#include "Flattening/PieceArrangement.h"
#include "Input/ClothInput.h"
#include "Input/CurvedSurface.h"
#include "ListChanges.h"
#include "Options/OptionStructures.h"
#include "PolyDataSets.h"
#include "Report/FlatteningRun.h"
#include "Report/FlatteningTables.h"
#include "Report/PieceSizes.h"
#include "SurfaceOutput.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

namespace flattening::bridge
{
namespace
{
/// A data set, and its number among the blocks.
struct Leaf
{
  vtkPolyData* data;
  double number;
};

std::vector<Leaf> leavesOf(vtkDataObject* object)
{
  std::vector<Leaf> leaves;
  const auto add = [&leaves](vtkDataObject* candidate, double number) {
    auto* const data = vtkPolyData::SafeDownCast(candidate);
    if (data && data->GetNumberOfPoints() > 0)
    {
      leaves.push_back({ data, number });
    }
  };
  add(object, 0.0);
  if (auto* const group = vtkCompositeDataSet::SafeDownCast(object))
  {
    const auto block = vtk::TakeSmartPointer(group->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      add(block->GetCurrentDataObject(), block->GetCurrentFlatIndex());
    }
  }
  return leaves;
}

/// Number of the block, process, width, height.
using BlockRow = std::array<double, 4>;

/// The rows of all processes in the order of the blocks.
std::vector<BlockRow> gatherRows(std::vector<BlockRow> rows, vtkMultiProcessController* processes)
{
  if (processes)
  {
    const vtkIdType length = static_cast<vtkIdType>(rows.size()) * std::tuple_size<BlockRow>::value;
    const auto count = static_cast<std::size_t>(processes->GetNumberOfProcesses());
    std::vector<vtkIdType> lengths(count);
    processes->AllGather(&length, lengths.data(), 1);
    std::vector<vtkIdType> offsets(count, 0);
    std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
    const auto all = static_cast<std::size_t>(offsets.back() + lengths.back());
    std::vector<BlockRow> gathered(all / std::tuple_size<BlockRow>::value);
    processes->AllGatherV(rows.empty() ? nullptr : rows.front().data(),
      gathered.empty() ? nullptr : gathered.front().data(), length, lengths.data(), offsets.data());
    rows = std::move(gathered);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

vtkBoundingBox boundsOf(const std::vector<Leaf>& leaves, vtkMultiProcessController* processes)
{
  vtkBoundingBox box;
  for (const Leaf& leaf : leaves)
  {
    box.AddBounds(leaf.data->GetBounds());
  }
  if (processes)
  {
    double low[3];
    double high[3];
    box.GetMinPoint(low[0], low[1], low[2]);
    box.GetMaxPoint(high[0], high[1], high[2]);
    double lowest[3];
    double highest[3];
    processes->AllReduce(low, lowest, 3, vtkCommunicator::MIN_OP);
    processes->AllReduce(high, highest, 3, vtkCommunicator::MAX_OP);
    box.SetMinPoint(lowest);
    box.SetMaxPoint(highest);
  }
  return box;
}

void move(vtkPolyData* flat, const Point2& shift)
{
  vtkPoints* const points = flat->GetPoints();
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    double point[3];
    points->GetPoint(p, point);
    points->SetPoint(p, point[0] + shift.x(), point[1] + shift.y(), point[2]);
  }
  points->Modified();
  flat->ComputeBounds();
}

/// Moves flat surfaces, those of all blocks and processes in rows, to the right of the surfaces in
/// space that they are of, at half their height. Their points are moved in place, and with them
/// those of the wires, which share them. Where there are several processes, all must call it.
/// \param spacing as in arrangePieces().
void layBeside(vtkDataObject* surfaces, vtkDataObject* flat, double spacing,
  vtkMultiProcessController* processes)
{
  const vtkBoundingBox space = boundsOf(leavesOf(surfaces), processes);
  const double process = processes ? processes->GetLocalProcessId() : 0;
  const std::vector<Leaf> leaves = leavesOf(flat);
  std::vector<BlockRow> rows;
  for (const Leaf& leaf : leaves)
  {
    const vtkBoundingBox box(leaf.data->GetBounds());
    rows.push_back({ leaf.number, process, box.GetLength(0), box.GetLength(1) });
  }
  rows = gatherRows(std::move(rows), processes);
  if (rows.empty() || !space.IsValid())
  {
    return;
  }

  std::vector<Point2> sizes;
  for (const BlockRow& row : rows)
  {
    sizes.emplace_back(row[2], row[3]);
  }
  const std::vector<Point2> corners = cornersInRows(sizes, spacing);
  double height = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    height = std::max(height, corners[k].y() + sizes[k].y());
    largest = std::max(largest, sizes[k].maxCoeff());
  }
  double middle[3];
  space.GetCenter(middle);
  const Point2 origin(
    space.GetMaxPoint()[0] + std::max(2.0 * spacing, 0.1) * largest, middle[1] - 0.5 * height);
  auto leaf = leaves.begin();
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    if (rows[k][1] == process)
    {
      const double* const bounds = leaf->data->GetBounds();
      move(leaf->data, origin + corners[k] - Point2(bounds[0], bounds[2]));
      ++leaf;
    }
  }
}
}
}

namespace
{
constexpr int piecePort = 3;
constexpr int curvePort = 4;
}

//------------------------------------------------------------------------------
vtkFlatPieceAlgorithm::vtkFlatPieceAlgorithm()
{
  this->SetTablePort(piecePort);
  this->SetTablePort(curvePort);
  this->KeepTables({});
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::AddGrain(const std::string& grain)
{
  if (std::find(this->Grain.begin(), this->Grain.end(), grain) == this->Grain.end())
  {
    this->Grain.push_back(grain);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::RemoveAllGrains()
{
  flattening::bridge::changeToNone(this, this->Grain);
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::SetMaterialFile(const char* path)
{
  flattening::bridge::change(this, this->MaterialFile, std::string(path ? path : ""));
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetPieces()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(piecePort));
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatPieceAlgorithm::GetCurves()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(curvePort));
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::KeepTables(const flattening::ReportTables& tables)
{
  namespace bridge = flattening::bridge;
  this->AngleIterations = bridge::makeTable(tables.angleIterations);
  this->IsometricIterations = bridge::makeTable(tables.isometricIterations);
  this->Releases = bridge::makeTable(tables.releaseTrials);
  this->PieceRemedies = bridge::makeTable(tables.pieceRemedies);
  this->LeftOutPieces = bridge::makeTable(tables.leftOutPieces);
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::FinishData(vtkInformationVector* outputVector)
{
  this->Superclass::FinishData(outputVector);
  if (this->IsRefused() && this->GetStatusCode() != NOT_RUN)
  {
    this->KeepTables({});
    this->SizeWarning.clear();
    std::fill_n(this->Seconds, 4, 0.0);
    flattening::bridge::writeTable(
      flattening::refusalTable(this->GetStatusName(), this->GetStatusMessage()),
      vtkTable::GetData(outputVector, piecePort));
  }
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::EndRun(vtkDataObject* input, vtkDataObject* output)
{
  if (this->BesideSurface)
  {
    flattening::bridge::layBeside(
      input, output, this->GetSpacing(), flattening::bridge::processesOf(this->GetDistributed()));
  }
}

//------------------------------------------------------------------------------
flattening::FlatteningOptions vtkFlatPieceAlgorithm::Settings()
{
  flattening::FlatteningOptions options = this->OptionsForCore().flattening;
  const std::string material =
    this->MaterialFile.empty() ? std::string(this->GetMaterial()) : this->MaterialFile;
  if (!material.empty())
  {
    options.cloth = flattening::readCloth(material, this->Grain);
  }
  const auto elastic = this->CurveTolerances.find(flattening::boundaryName);
  options.boundaryTolerance = elastic == this->CurveTolerances.end() ? 0.0 : elastic->second;
  return options;
}

//------------------------------------------------------------------------------
const char* vtkFlatPieceAlgorithm::WeightName()
{
  vtkInformation* const array = this->GetInputArrayInformation(0);
  return array->Has(vtkDataObject::FIELD_NAME()) ? array->Get(vtkDataObject::FIELD_NAME()) : "";
}

//------------------------------------------------------------------------------
bool vtkFlatPieceAlgorithm::Weigh(
  flattening::FlatteningRun& run, const flattening::bridge::CurvedPolyData& source)
{
  return run.weigh(flattening::bridge::columnsOf(source.cellArrays), this->WeightName());
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::ListMaterials(vtkTable* materials)
{
  if (materials)
  {
    flattening::bridge::writeTable(flattening::materialTable(), materials);
  }
}

//------------------------------------------------------------------------------
int vtkFlatPieceAlgorithm::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  if (const auto source = this->LoadInput(inputVector))
  {
    const flattening::FlatteningOptions options = this->Settings();
    flattening::FlatteningRun run(*source);
    std::optional<flattening::FlatteningResult> result;
    if (this->Weigh(run, *source))
    {
      result = run.flatten(options, { this->Pins[0], this->Pins[1] },
        flattening::bridge::executionOf(this), this->KeptPieces());
    }
    this->TakeResult(run, *source, result ? &*result : nullptr, options, inputVector, outputVector);
  }
  this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
  return 1;
}

//------------------------------------------------------------------------------
bool vtkFlatPieceAlgorithm::TakeResult(const flattening::FlatteningRun& run,
  const flattening::bridge::CurvedPolyData& source, const flattening::FlatteningResult* result,
  const flattening::FlatteningOptions& options, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  namespace bridge = flattening::bridge;
  this->Warn(run.warnings);
  if (!this->Conclude(run.status) || !result)
  {
    return false;
  }
  vtkPolyData* const flat = vtkPolyData::GetData(outputVector, 0);
  bridge::writeFlattening(source, *result, options, flat, vtkPolyData::GetData(outputVector, 1),
    vtkPolyData::GetData(outputVector, 2));
  const std::string unit = this->LengthUnitOf(inputVector);
  const flattening::ReportTables tables(
    source, *result, unit, bridge::textsOfCells(flat, "PieceName"));
  bridge::writeTable(tables.pieces, vtkTable::GetData(outputVector, piecePort));
  bridge::writeTable(tables.curves, vtkTable::GetData(outputVector, curvePort));
  this->KeepTables(tables);
  this->SizeWarning = flattening::sizeWarning(flattening::pieceSizes(*result), unit);
  if (!unit.empty() && !this->SizeWarning.empty())
  {
    this->Warn({ this->SizeWarning });
  }
  const flattening::StageSeconds& seconds = result->seconds;
  const double all[4] = { seconds.wires, seconds.interior, seconds.quality, seconds.total };
  std::copy_n(all, 4, this->Seconds);
  return true;
}

//------------------------------------------------------------------------------
void vtkFlatPieceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BesideSurface: " << (this->BesideSurface ? "On" : "Off") << "\n";
  os << indent << "Seconds: " << this->Seconds[3] << "\n";
  os << indent << "SizeWarning: " << this->SizeWarning << "\n";
  os << indent << "MaterialFile: " << this->MaterialFile << "\n";
  for (const std::string& grain : this->Grain)
  {
    os << indent << "Grain: " << grain << "\n";
  }
}
