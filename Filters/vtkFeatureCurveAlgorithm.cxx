// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveAlgorithm.h"

#include "CurvedPolyData.h"
#include "Distribution.h"
#include "FilterExecution.h"
#include "Flattening/SurfaceFlattening.h"
#include "ListChanges.h"
#include "Options/OptionStructures.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationVector.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>
#include <memory>

namespace flattening::bridge
{
/// What a filter keeps from one run to the next.
struct KeptRun
{
  std::shared_ptr<CurvedPolyData> source;
  FlatteningCache pieces;
};
}

namespace
{
using flattening::bridge::ConnectedCurves;

/// Adds all leaves of a composite data set, each by the name of its block, or by its number.
void addLeaves(vtkCompositeDataSet* group, int connection, ConnectedCurves& curves)
{
  const auto node = vtk::TakeSmartPointer(group->NewIterator());
  auto* const tree = vtkDataObjectTreeIterator::SafeDownCast(node);
  if (tree)
  {
    tree->VisitOnlyLeavesOff();
  }
  // The partitions of a data set are named by it.
  std::string whole;
  unsigned int lastOfWhole = 0;
  for (node->InitTraversal(); !node->IsDoneWithTraversal(); node->GoToNextItem())
  {
    const char* const own = node->HasCurrentMetaData()
      ? node->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
      : nullptr;
    const unsigned int number = node->GetCurrentFlatIndex();
    const std::string name = own ? own : number <= lastOfWhole ? whole : "";
    vtkDataObject* const object = node->GetCurrentDataObject();
    if (auto* const partitions = vtkPartitionedDataSet::SafeDownCast(object))
    {
      whole = name;
      lastOfWhole = number + partitions->GetNumberOfPartitions();
    }
    else if (auto* const leaf = vtkPolyData::SafeDownCast(object))
    {
      curves.data.emplace_back(leaf);
      curves.connections.push_back(connection);
      curves.blocks.push_back(
        "block " + (name.empty() ? std::to_string(number) : "\"" + name + "\""));
    }
  }
}

/// The data sets of all connections, with all leaves of composite ones.
ConnectedCurves leavesOf(vtkInformationVector* connected)
{
  ConnectedCurves leaves;
  for (int i = 0; i < connected->GetNumberOfInformationObjects(); ++i)
  {
    if (vtkPolyData* const curves = vtkPolyData::GetData(connected, i))
    {
      leaves.data.emplace_back(curves);
      leaves.connections.push_back(i);
      leaves.blocks.emplace_back();
    }
    if (vtkCompositeDataSet* const group = vtkCompositeDataSet::GetData(connected, i))
    {
      addLeaves(group, i, leaves);
    }
  }
  return leaves;
}
}

//------------------------------------------------------------------------------
vtkFeatureCurveAlgorithm::vtkFeatureCurveAlgorithm()
{
  this->SetNumberOfInputPorts(2);
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
vtkFeatureCurveAlgorithm::~vtkFeatureCurveAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkFeatureCurveAlgorithm::AddCurveTolerance(const std::string& curve, double tolerance)
{
  flattening::bridge::changeEntry(this, this->CurveTolerances, curve, tolerance);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveAlgorithm::RemoveAllCurveTolerances()
{
  flattening::bridge::changeToNone(this, this->CurveTolerances);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    // A composite data set first: a group of curves is taken whole, never iterated over.
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
    return 1;
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
const char* vtkFeatureCurveAlgorithm::GetOutputPointsPrecisionAsString() const
{
  static const char* const names[] = { "Single", "Double", "Default" };
  return names[this->OutputPointsPrecision];
}

//------------------------------------------------------------------------------
void vtkFeatureCurveAlgorithm::BeginRun(vtkInformationVector** inputVector)
{
  namespace bridge = flattening::bridge;
  this->Gathered.reset();
  if (auto* const processes = bridge::processesOf(this->GetDistributed()))
  {
    this->Gathered = std::make_unique<bridge::ConnectedCurves>(
      bridge::gatherCurves(leavesOf(inputVector[1]), processes));
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveAlgorithm::FinishData(vtkInformationVector* outputVector)
{
  // Outputs share their points, rounded ones as well.
  std::map<vtkPoints*, vtkSmartPointer<vtkPoints>> rounded;
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkPolyData* const output = vtkPolyData::GetData(outputVector, port);
    vtkPoints* const points = output ? output->GetPoints() : nullptr;
    if (this->OutputPointsPrecision != SINGLE_PRECISION || !points)
    {
      continue;
    }
    vtkSmartPointer<vtkPoints>& copy = rounded[points];
    if (!copy)
    {
      copy = vtkSmartPointer<vtkPoints>::New();
      copy->SetDataTypeToFloat();
      copy->GetData()->DeepCopy(points->GetData());
    }
    output->SetPoints(copy);
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<flattening::bridge::CurvedPolyData> vtkFeatureCurveAlgorithm::LoadInput(
  vtkInformationVector** inputVector)
{
  const flattening::bridge::ConnectedCurves connected =
    this->Gathered ? *this->Gathered : leavesOf(inputVector[1]);
  const std::vector<vtkPolyData*> curves(connected.data.begin(), connected.data.end());
  static_assert(static_cast<int>(flattening::CoincidentPoints::Join) == JOIN, "");
  static_assert(static_cast<int>(flattening::CoincidentPoints::Keep) == KEEP, "");
  const flattening::OptionStructures options = this->OptionsForCore();
  if (!this->Caching)
  {
    this->Kept.reset();
  }
  else if (!this->Kept)
  {
    this->Kept = std::make_unique<flattening::bridge::KeptRun>();
    this->Kept->source = std::make_shared<flattening::bridge::CurvedPolyData>();
  }
  auto source =
    this->Kept ? this->Kept->source : std::make_shared<flattening::bridge::CurvedPolyData>();
  flattening::bridge::loadCurvedSurface(vtkPolyData::GetData(inputVector[0]), curves,
    options.coincidentPoints, options.defects(), options.imprint,
    flattening::bridge::executionOf(this), *source);
  // The surface's own curves, source 0, have no connection.
  const auto blamed = static_cast<std::size_t>(std::max(source->blamed, 0));
  this->StatusConnection = blamed == 0 ? -1 : connected.connections[blamed - 1];
  if (this->StatusConnection >= 0)
  {
    const std::string& block = connected.blocks[blamed - 1];
    std::string place = inputVector[1]->GetNumberOfInformationObjects() > 1
      ? "connection " + std::to_string(this->StatusConnection)
      : "";
    place += (place.empty() || block.empty() ? "" : ", ") + block;
    source->outcome.message =
      (place.empty() ? "" : place + " of the curves: ") + source->outcome.message;
  }
  const bool loaded = this->Conclude(source->outcome) &&
    this->Conclude(flattening::applyTolerances(this->CurveTolerances, *source));
  if (!loaded)
  {
    return nullptr;
  }
  this->Warn(source->warnings);
  return source;
}

//------------------------------------------------------------------------------
flattening::FlatteningCache* vtkFeatureCurveAlgorithm::KeptPieces() const
{
  return this->Kept ? &this->Kept->pieces : nullptr;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& entry : this->CurveTolerances)
  {
    os << indent << "CurveTolerance " << entry.first << ": " << entry.second << "\n";
  }
  os << indent << "OutputPointsPrecision: " << this->GetOutputPointsPrecisionAsString() << "\n";
  os << indent << "Caching: " << (this->Caching ? "On" : "Off") << "\n";
}
