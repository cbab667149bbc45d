// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternGrading.h"

#include "ListChanges.h"
#include "PatternInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

vtkStandardNewMacro(vtkPatternGrading);

namespace
{
namespace pattern = flattening::pattern;
using flattening::Status;
}

//------------------------------------------------------------------------------
vtkPatternGrading::vtkPatternGrading()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkPatternGrading::~vtkPatternGrading() = default;

//------------------------------------------------------------------------------
void vtkPatternGrading::AddSize(const std::string& name, vtkPolyData* flat, vtkPolyData* wires)
{
  this->SetSizeName(this->GetNumberOfInputConnections(0), name);
  int port = 0;
  for (vtkPolyData* data : { flat, wires })
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(data);
    this->AddInputConnection(port++, producer->GetOutputPort());
  }
}

//------------------------------------------------------------------------------
void vtkPatternGrading::RemoveAllWires()
{
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
void vtkPatternGrading::SetSizeName(int size, const std::string& name)
{
  if (size < 0)
  {
    vtkErrorMacro("Sizes are counted from 0, not from " << size << ".");
    return;
  }
  std::vector<std::string> names = this->SizeNames;
  for (int k = this->GetNumberOfSizeNames(); k <= size; ++k)
  {
    names.push_back(std::to_string(k + 1));
  }
  names[static_cast<std::size_t>(size)] = name;
  flattening::bridge::change(this, this->SizeNames, std::move(names));
}

//------------------------------------------------------------------------------
const char* vtkPatternGrading::GetSizeName(int size) const
{
  return size >= 0 && size < this->GetNumberOfSizeNames()
    ? this->SizeNames[static_cast<std::size_t>(size)].c_str()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkPatternGrading::RemoveAllSizeNames()
{
  flattening::bridge::changeToNone(this, this->SizeNames);
}

//------------------------------------------------------------------------------
const char* vtkPatternGrading::GetUnitAsString() const
{
  static const char* const names[] = { "Millimetre", "Centimetre", "Metre", "Inch" };
  return names[this->Unit - MILLIMETRE];
}

//------------------------------------------------------------------------------
int vtkPatternGrading::FillInputPortInformation(int port, vtkInformation* info)
{
  const int done = this->Superclass::FillInputPortInformation(port, info);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return done;
}

//------------------------------------------------------------------------------
int vtkPatternGrading::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
  const int count = inputVector[0]->GetNumberOfInformationObjects();
  Status status;
  if (inputVector[1]->GetNumberOfInformationObjects() != count)
  {
    status = { flattening::StatusCode::InvalidOption,
      "there are flat pieces of " + std::to_string(count) + " sizes and wires of " +
        std::to_string(inputVector[1]->GetNumberOfInformationObjects()) };
  }
  std::vector<pattern::PatternSize> sizes;
  for (int k = 0; k < count && status.ok(); ++k)
  {
    pattern::PatternSize& size = sizes.emplace_back();
    size.name = this->GetSizeName(k) ? this->GetSizeName(k) : std::to_string(k + 1);
    status = flattening::bridge::readPieces(vtkPolyData::GetData(inputVector[0], k),
      vtkPolyData::GetData(inputVector[1], k), nullptr, size.source);
  }
  pattern::Grading grading;
  if (status.ok())
  {
    pattern::GradingOptions options;
    options.unit = static_cast<flattening::Unit>(this->Unit);
    options.base = this->BaseSize;
    options.alignment = this->AlignmentCurve;
    status = pattern::gradeSizes(sizes, options, grading);
  }
  if (this->Conclude(status))
  {
    flattening::bridge::writeGrading(grading, output);
  }
  this->WriteRunStatus(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPatternGrading::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const std::string& name : this->SizeNames)
  {
    os << indent << "SizeName: " << name << "\n";
  }
  os << indent << "BaseSize: " << this->BaseSize << "\n";
  os << indent << "AlignmentCurve: " << this->AlignmentCurve << "\n";
  os << indent << "Unit: " << this->GetUnitAsString() << "\n";
}
