// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSewnShape.h"

#include "BodyInput.h"
#include "ClothInput.h"
#include "FilterExecution.h"
#include "ListChanges.h"
#include "Sewing/PieceSewing.h"
#include "SewnInput.h"
#include "SewnOutput.h"
#include "StatusInInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkSewnShape);

//------------------------------------------------------------------------------
vtkSewnShape::vtkSewnShape()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
  const flattening::SewingOptions defaults;
  this->Test = defaults.test == flattening::SewingTest::Product ? PRODUCT : PANEL;
  this->Thickness = defaults.thickness;
  this->AreaBias = defaults.areaBias;
  this->MaximumIterations = defaults.maximumIterations;
  this->Pressure = defaults.pressure;
  std::copy(defaults.gravity.begin(), defaults.gravity.end(), this->Gravity);
  this->SecondStart = defaults.secondStart;
}

//------------------------------------------------------------------------------
vtkSewnShape::~vtkSewnShape() = default;

//------------------------------------------------------------------------------
void vtkSewnShape::SetDesignConnection(vtkAlgorithmOutput* design)
{
  this->SetInputConnection(1, design);
}

//------------------------------------------------------------------------------
void vtkSewnShape::SetDesignData(vtkPolyData* design)
{
  this->SetInputData(1, design);
}

//------------------------------------------------------------------------------
void vtkSewnShape::SetBodyConnection(vtkAlgorithmOutput* body)
{
  this->SetInputConnection(2, body);
}

//------------------------------------------------------------------------------
void vtkSewnShape::SetBodyData(vtkPolyData* body)
{
  this->SetInputData(2, body);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSewnShape::GetDesignOutput()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
void vtkSewnShape::SetMaterial(const char* text)
{
  if (flattening::bridge::change(this->Material, std::string(text ? text : "")))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkSewnShape::GetTestAsString() const
{
  return this->Test == PRODUCT ? "product" : "panel";
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
  vtkPolyData* design = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const flattening::bridge::SewnInput input =
    flattening::bridge::loadSewnInput(vtkPolyData::GetData(inputVector[0]), design);
  const flattening::bridge::LoadedBody body =
    flattening::bridge::loadBody(vtkPolyData::GetData(inputVector[2]));
  if (this->Conclude(input.outcome) && this->Conclude(body.outcome))
  {
    flattening::SewingOptions options;
    options.test =
      this->Test == PRODUCT ? flattening::SewingTest::Product : flattening::SewingTest::Panel;
    options.thickness = this->Thickness;
    options.areaBias = this->AreaBias;
    options.maximumIterations = this->MaximumIterations;
    options.pressure = this->Pressure;
    options.secondStart = this->SecondStart;
    options.gravity = flattening::Point3(this->Gravity);
    if (!this->Material.empty())
    {
      options.material = flattening::bridge::readCloth(this->Material, "").material;
    }
    options.body = body.get();
    const flattening::SewingResult result = flattening::sewPieces(
      input.cut, input.map.positions, options, flattening::bridge::executionOf(this));
    if (this->Conclude(
          flattening::bridge::inInput(result.status, input.map.surface.input.cellOfTriangle)))
    {
      std::vector<std::string> warnings;
      flattening::bridge::writeSewn(
        design, input, result, output, vtkPolyData::GetData(outputVector, 1), warnings);
      this->Warn(warnings);
    }
  }
  this->WriteRunStatus(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSewnShape::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Test: " << this->GetTestAsString() << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "AreaBias: " << this->AreaBias << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Pressure: " << this->Pressure << "\n";
  os << indent << "Gravity: " << this->Gravity[0] << ", " << this->Gravity[1] << ", "
     << this->Gravity[2] << "\n";
  os << indent << "Material: " << this->Material << "\n";
  os << indent << "SecondStart: " << (this->SecondStart ? "On" : "Off") << "\n";
}
