// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlatteningAlgorithm.h"

#include "AttributeArrays.h"
#include "Base/LengthUnit.h"
#include "Base/Memory.h"
#include "Distribution.h"
#include "Input/StatusWords.h"
#include "OptionProperties.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "Options/OptionValues.h"

#include "vtkAbstractArray.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <new>
#include <sstream>
#include <stdexcept>

namespace
{
using flattening::StatusCode;

/// Of the most derived class that has options.
flattening::OptionOwner ownerOf(const vtkObject* object)
{
  auto* const filter = const_cast<vtkObject*>(object); // IsA() is not const
  auto owner = flattening::OptionOwner::Curves;
  for (const flattening::Option& option : flattening::optionTable())
  {
    owner = filter->IsA(flattening::className(option.owner)) ? option.owner : owner;
  }
  return owner;
}

// The public codes are Core's, in its order.
constexpr bool same(int publicCode, StatusCode code)
{
  return publicCode == static_cast<int>(code);
}
static_assert(same(vtkFlatteningAlgorithm::OK, StatusCode::Ok), "");
static_assert(same(vtkFlatteningAlgorithm::HANDLE, StatusCode::Handle), "");
static_assert(same(vtkFlatteningAlgorithm::NUMERICAL_FAILURE, StatusCode::LastRefusal), "");
static_assert(same(vtkFlatteningAlgorithm::LENGTH_ERROR, StatusCode::LengthError), "");
static_assert(same(vtkFlatteningAlgorithm::BEYOND_LIMITS, StatusCode::BeyondLimits), "");

/// Set while it lives.
class RunningMark
{
public:
  explicit RunningMark(bool& running)
    : Running(running)
    , Before(running)
  {
    running = true;
  }
  ~RunningMark() { this->Running = this->Before; }
  RunningMark(const RunningMark&) = delete;
  RunningMark& operator=(const RunningMark&) = delete;

private:
  bool& Running;
  bool Before;
};

}

//------------------------------------------------------------------------------
std::string vtkFlatteningAlgorithm::GetLengthUnitOf(vtkDataObject* data)
{
  vtkFieldData* const field = data ? data->GetFieldData() : nullptr;
  auto* const stated =
    vtkStringArray::SafeDownCast(field ? field->GetAbstractArray("LengthUnit") : nullptr);
  const flattening::Unit unit = stated && stated->GetNumberOfValues() > 0
    ? flattening::unitNamed(stated->GetValue(0))
    : flattening::Unit::Unspecified;
  return unit == flattening::Unit::Unspecified ? std::string() : flattening::unitName(unit);
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::SetLengthUnitOf(vtkDataObject* data, const std::string& unit)
{
  if (!data)
  {
    return;
  }
  data->GetFieldData()->RemoveArray("LengthUnit");
  const flattening::Unit known = flattening::unitNamed(unit);
  if (known != flattening::Unit::Unspecified)
  {
    flattening::bridge::addColumns(data->GetFieldData(),
      { { "LengthUnit", std::vector<std::string>{ flattening::unitName(known) } } });
  }
}

//------------------------------------------------------------------------------
std::string vtkFlatteningAlgorithm::LengthUnitOf(vtkInformationVector** inputVector)
{
  std::string unit;
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int k = 0; unit.empty() && k < inputVector[port]->GetNumberOfInformationObjects(); ++k)
    {
      unit = GetLengthUnitOf(vtkDataObject::GetData(inputVector[port], k));
    }
  }
  return unit;
}

//------------------------------------------------------------------------------
vtkFlatteningAlgorithm::vtkFlatteningAlgorithm()
{
  this->Forget();
  this->Options =
    std::make_unique<flattening::OptionValues>(std::vector<const flattening::Option*>());
  this->AllOwners =
    std::make_unique<std::map<const vtkDataObject*, flattening::bridge::SurfaceOwners>>();
  this->Owners = std::make_unique<flattening::bridge::SurfaceOwners>();
  this->AddObserver(vtkCommand::EndEvent, this, &vtkFlatteningAlgorithm::LeaveRun);
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::Forget()
{
  this->Keep({});
  this->StatusWarnings = vtkSmartPointer<vtkStringArray>::New();
  this->StatusCode = NOT_RUN;
  this->StatusDefect = "the filter has not run";
  this->StatusMessage = this->StatusDefect + "; update it, and see that its input can be read";
}

//------------------------------------------------------------------------------
std::string vtkFlatteningAlgorithm::DescribeIdleOption(const std::string& given)
{
  flattening::OptionValues values = this->AllOptions();
  if (ownerOf(this) == flattening::OptionOwner::Conformal)
  {
    // The conformal map is a scheme among others in what options need.
    values = flattening::OptionValues(flattening::OptionOwner::Warping);
    values.setWord("Scheme", "lscm");
    values.markGiven("Scheme");
  }
  std::istringstream names(given);
  for (std::string name; names >> name;)
  {
    values.markGiven(name);
  }
  return flattening::describeIdleOption(values, flattening::OptionSpelling::Property);
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::SetDefaultOptions()
{
  // Within a constructor these are the options of its class and of those that it derives from.
  this->Options = std::make_unique<flattening::OptionValues>(ownerOf(this));
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::SetNumberOption(const char* property, double value)
{
  flattening::bridge::setNumber(this, *this->Options, property, value);
}

//------------------------------------------------------------------------------
double vtkFlatteningAlgorithm::GetNumberOption(const char* property) const
{
  return this->Options->number(property);
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::SetTextOption(const char* property, const char* text)
{
  flattening::bridge::setText(this, *this->Options, property, text ? text : "");
}

//------------------------------------------------------------------------------
const char* vtkFlatteningAlgorithm::GetTextOption(const char* property) const
{
  return std::get<std::string>((*this->Options)[property]).c_str();
}

//------------------------------------------------------------------------------
const char* vtkFlatteningAlgorithm::GetOptionWord(const char* property) const
{
  return flattening::bridge::nameOfWord(*this->Options, property);
}

//------------------------------------------------------------------------------
flattening::OptionValues vtkFlatteningAlgorithm::AllOptions()
{
  flattening::OptionValues values = *this->Options;
  this->AddOtherOptions(values);
  return values;
}

//------------------------------------------------------------------------------
flattening::OptionStructures vtkFlatteningAlgorithm::OptionsForCore()
{
  flattening::OptionStructures structures;
  const flattening::OptionValues values = this->AllOptions();
  structures.proposes = values.find("SuggestedCuts") != nullptr;
  for (const flattening::Option* const option : values.options())
  {
    if (option->set)
    {
      option->set(structures, values[option->property]);
    }
  }
  return structures;
}

//------------------------------------------------------------------------------
vtkFlatteningAlgorithm::~vtkFlatteningAlgorithm() = default;

//------------------------------------------------------------------------------
vtkTypeBool vtkFlatteningAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const RunningMark mark(this->Running);
  // Core answers itself where its own memory runs out; here what stands around it does. TBB throws
  // a std::runtime_error where it cannot start a thread.
  const auto ranOut = [this, outputVector](const flattening::Status& status) {
    this->Begin(outputVector);
    this->Conclude(status);
    this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
    this->FinishData(outputVector);
    return this->HasFailed() ? 0 : 1;
  };
  try
  {
    // A run comes next, unless its input cannot be read.
    const bool asked = request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) ||
      request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT());
    if (asked && !this->AmongBlocks)
    {
      this->Forget();
    }
    if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED()))
    {
      this->EnterRun(inputVector);
    }
    const bool run = request->Has(vtkDemandDrivenPipeline::REQUEST_DATA());
    if (run && !this->HasSurface(outputVector))
    {
      this->FinishData(outputVector);
      return this->HasFailed() ? 0 : 1;
    }
    const vtkTypeBool done = this->Superclass::ProcessRequest(request, inputVector, outputVector);
    if (run)
    {
      const std::string unit = this->IsRefused() ? "" : this->LengthUnitOf(inputVector);
      for (int k = 0; !unit.empty() && k < outputVector->GetNumberOfInformationObjects(); ++k)
      {
        SetLengthUnitOf(vtkPolyData::GetData(outputVector, k), unit);
      }
      this->FinishData(outputVector);
    }
    return run && this->HasFailed() ? 0 : done;
  }
  catch (const flattening::SystemLimit& error)
  {
    return ranOut(flattening::outOfThreads(error.what()));
  }
  catch (const std::bad_alloc&)
  {
    return ranOut(flattening::outOfMemory(0));
  }
  catch (const std::runtime_error& error)
  {
    return ranOut(flattening::outOfThreads(error.what()));
  }
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::EnterRun(vtkInformationVector** inputVector)
{
  // The executive says so for the whole composite data set first, then for each of its blocks.
  vtkDataObject* const surface =
    this->GetNumberOfInputConnections(0) > 0 ? vtkDataObject::GetData(inputVector[0]) : nullptr;
  const bool composite = vtkCompositeDataSet::SafeDownCast(surface) != nullptr;
  if (!this->AmongBlocks || composite)
  {
    *this->AllOwners =
      flattening::bridge::ownersOf(surface, flattening::bridge::processesOf(this->Distributed));
    this->AmongBlocks = composite;
    this->BeginRun(inputVector);
  }
  const auto owners = this->AllOwners->find(surface);
  *this->Owners =
    owners == this->AllOwners->end() ? flattening::bridge::SurfaceOwners() : owners->second;
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::LeaveRun()
{
  vtkDataObject* const input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  if (this->AmongBlocks && !vtkCompositeDataSet::SafeDownCast(input))
  {
    return;
  }
  if (this->StatusCode == CANCELLED && this->GetAbortExecute())
  {
    this->SetAbortExecute(0); // It has been heard; VTK 9.3 would keep it for the next run.
  }
  this->AmongBlocks = false;
  this->AllOwners->clear();
  this->EndRun(input, this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
bool vtkFlatteningAlgorithm::HasSurface(vtkInformationVector* outputVector)
{
  const bool spread = this->Owners->parts > 1 && !this->TakesParts();
  if (!spread && this->Owners->here)
  {
    return true;
  }
  this->Begin(outputVector);
  if (spread)
  {
    flattening::Status refusal;
    refusal.code = StatusCode::InvalidOption;
    refusal.message = this->Owners->processes > 1
      ? "the surface is spread over " + std::to_string(this->Owners->processes) +
        " processes, and each would flatten its part for itself; give all of it to one process "
        "(in ParaView: Aggregate Dataset to 1 process, then Coincident Points: Join)"
      : "the surface comes in " + std::to_string(this->Owners->parts) +
        " partitions, and each would be flattened for itself; join them (in ParaView: Merge "
        "Blocks, "
        "then Coincident Points: Join), or give surfaces of their own as blocks of a multi-block "
        "data set";
    if (this->Owners->first)
    {
      this->Conclude(refusal);
    }
    else
    {
      this->Keep(refusal);
      this->SetErrorCode(vtkErrorCode::UserError);
    }
    this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
    return false;
  }
  this->StatusCode = NOT_RUN;
  this->StatusMessage = this->StatusDefect = "another process has the surface";
  this->SetErrorCode(vtkErrorCode::NoError);
  return false;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFlatteningAlgorithm::GetMTime()
{
  // The pipeline takes an aborted run for one that is up to date.
  if (this->StatusCode == CANCELLED && !this->Running)
  {
    this->Modified();
  }
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
const char* vtkFlatteningAlgorithm::GetStatusName() const
{
  return this->StatusCode == NOT_RUN
    ? "NotRun"
    : flattening::statusName(static_cast<flattening::StatusCode>(this->StatusCode));
}

//------------------------------------------------------------------------------
int vtkFlatteningAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (this->OptionalPorts.count(port) != 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkFlatteningAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    this->TablePorts.count(port) != 0 ? "vtkTable" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::SetOptionalPort(int port)
{
  this->OptionalPorts.insert(port);
  this->SetNumberOfInputPorts(std::max(this->GetNumberOfInputPorts(), port + 1));
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::SetTablePort(int port)
{
  this->TablePorts.insert(port);
  this->SetNumberOfOutputPorts(std::max(this->GetNumberOfOutputPorts(), port + 1));
}

//------------------------------------------------------------------------------
int vtkFlatteningAlgorithm::GetNumberOfRemedies()
{
  return flattening::remedyCount;
}

//------------------------------------------------------------------------------
const char* vtkFlatteningAlgorithm::GetRemedyName(int remedy)
{
  return remedy >= 0 && remedy < flattening::remedyCount
    ? flattening::remedyName(static_cast<flattening::Remedy>(remedy))
    : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkFlatteningAlgorithm::GetRemedySentence(const char* name)
{
  return name ? flattening::remedySentence(name) : nullptr;
}

//------------------------------------------------------------------------------
bool vtkFlatteningAlgorithm::IsRefused() const
{
  return this->StatusCode != OK && this->StatusCode <= NUMERICAL_FAILURE;
}

//------------------------------------------------------------------------------
bool vtkFlatteningAlgorithm::HasFailed() const
{
  // The executive would give up the other blocks as well, and another process would wait for this
  // one in the filters behind.
  return this->IsRefused() && this->StatusCode != NOT_RUN && this->StatusCode != CANCELLED &&
    !this->AmongBlocks && !flattening::bridge::processesOf(this->Distributed);
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::Begin(vtkInformationVector* outputVector)
{
  this->Keep({});
  this->StatusWarnings = vtkSmartPointer<vtkStringArray>::New();
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize();
  }
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::Keep(const flattening::Status& outcome)
{
  this->StatusCode = static_cast<int>(outcome.code);
  this->StatusDefect = outcome.message;
  this->StatusMessage = flattening::inWords(outcome);
  this->StatusIdKind = flattening::kindName(outcome.ids.kind);
  // New arrays: the caller may have kept those of the last run.
  this->StatusIds = vtkSmartPointer<vtkIdTypeArray>::New();
  this->StatusRemedies = vtkSmartPointer<vtkStringArray>::New();
  this->StatusRemedySubjects = vtkSmartPointer<vtkStringArray>::New();
  for (const std::int64_t id : outcome.ids.values)
  {
    this->StatusIds->InsertNextValue(id);
  }
  for (const flattening::SuggestedRemedy& suggested : outcome.remedies)
  {
    this->StatusRemedies->InsertNextValue(flattening::remedyName(suggested.remedy));
    this->StatusRemedySubjects->InsertNextValue(suggested.subject);
  }
}

//------------------------------------------------------------------------------
bool vtkFlatteningAlgorithm::Conclude(const flattening::Status& outcome)
{
  this->Keep(outcome);
  this->SetErrorCode(this->IsRefused() ? vtkErrorCode::UserError : vtkErrorCode::NoError);
  if (this->IsRefused())
  {
    if (this->StatusCode != CANCELLED)
    {
      vtkErrorMacro(<< this->GetStatusName() << ": " << this->StatusMessage);
    }
    return false;
  }
  if (this->StatusCode != OK)
  {
    vtkWarningMacro(<< this->GetStatusName() << ": " << this->StatusMessage);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::Warn(const std::vector<std::string>& messages)
{
  for (const std::string& message : messages)
  {
    if (this->StatusWarnings->LookupValue(message) < 0)
    {
      this->StatusWarnings->InsertNextValue(message);
      vtkWarningMacro(<< message);
    }
  }
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::WriteRunStatus(vtkPolyData* output) const
{
  flattening::bridge::addColumns(output->GetFieldData(),
    { { "RunStatus", std::vector<std::string>{ this->GetStatusName() } },
      { "RunStatusMessage", std::vector<std::string>{ this->StatusMessage } } });
}

//------------------------------------------------------------------------------
void vtkFlatteningAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  flattening::bridge::print(this->AllOptions(), os, indent);
  os << indent << "Status: " << this->GetStatusName() << "\n";
  os << indent << "StatusMessage: " << this->StatusMessage << "\n";
  os << indent << "StatusIds: " << this->StatusIds->GetNumberOfValues() << " ids\n";
  os << indent << "Distributed: " << (this->Distributed ? "On" : "Off") << "\n";
  os << indent << "StatusWarnings: " << this->StatusWarnings->GetNumberOfValues() << "\n";
}
