// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlatteningQuality.h"

#include "FilterExecution.h"
#include "Quality/BoundaryOverlap.h"
#include "QualityInput.h"
#include "QualityOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFlatteningQuality);

//------------------------------------------------------------------------------
vtkFlatteningQuality::vtkFlatteningQuality()
{
  this->SetNumberOfInputPorts(3);
  this->SetTablePort(1);
  this->MaximumOverlaps = static_cast<int>(flattening::mostListedOverlaps);
}

//------------------------------------------------------------------------------
vtkFlatteningQuality::~vtkFlatteningQuality() = default;

//------------------------------------------------------------------------------
void vtkFlatteningQuality::SetFlatConnection(vtkAlgorithmOutput* flat)
{
  this->SetInputConnection(1, flat);
}

//------------------------------------------------------------------------------
void vtkFlatteningQuality::SetFlatData(vtkPolyData* flat)
{
  this->SetInputData(1, flat);
}

//------------------------------------------------------------------------------
void vtkFlatteningQuality::SetEdgesConnection(vtkAlgorithmOutput* edges)
{
  this->SetInputConnection(2, edges);
}

//------------------------------------------------------------------------------
void vtkFlatteningQuality::SetEdgesData(vtkPolyData* edges)
{
  this->SetInputData(2, edges);
}

//------------------------------------------------------------------------------
vtkTable* vtkFlatteningQuality::GetMeasures()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkFlatteningQuality::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFlatteningQuality::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const flattening::bridge::MappedSurface map = flattening::bridge::loadMappedSurface(
    surface, vtkPolyData::GetData(inputVector[1]), vtkPolyData::GetData(inputVector[2]));
  if (this->Conclude(map.outcome))
  {
    std::vector<std::string> warnings;
    flattening::bridge::writeQuality(surface, map, static_cast<std::size_t>(this->MaximumOverlaps),
      flattening::bridge::executionOf(this), output, vtkTable::GetData(outputVector, 1), warnings);
    this->Warn(warnings);
  }
  this->WriteRunStatus(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkFlatteningQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumOverlaps: " << this->MaximumOverlaps << "\n";
}
