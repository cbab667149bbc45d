// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSewnShape.h"

#include "BodyInput.h"
#include "ClothInput.h"
#include "FilterExecution.h"
#include "ListChanges.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "Sewing/PieceSewing.h"
#include "SewnInput.h"
#include "SewnOutput.h"
#include "StatusInInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkSewnShape);

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
  const flattening::bridge::LoadedBody body =
    flattening::bridge::loadBody(vtkPolyData::GetData(inputVector[2]));
  if (this->Conclude(input.outcome) && this->Conclude(body.outcome))
  {
    flattening::SewingOptions options = this->OptionsForCore().sewing;
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
      flattening::bridge::writeSewn(design, input, result, output,
        vtkPolyData::GetData(outputVector, 1), vtkTable::GetData(outputVector, 2), warnings);
      this->Iterations = flattening::bridge::sewingIterations(result);
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
}
