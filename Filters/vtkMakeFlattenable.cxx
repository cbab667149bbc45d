// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMakeFlattenable.h"

#include "BodyInput.h"
#include "CurvedSurface.h"
#include "CutEndWords.h"
#include "FilterExecution.h"
#include "FlattenableOutput.h"
#include "ListChanges.h"
#include "PieceSizes.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMakeFlattenable);

//------------------------------------------------------------------------------
vtkMakeFlattenable::vtkMakeFlattenable()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(6);
  const flattening::FlattenableOptions defaults;
  this->Bound = defaults.bound;
  this->KeepBoundary = defaults.keepBoundary;
  this->OutsideBias = defaults.outsideBias;
  this->Thickness = defaults.thickness;
}

//------------------------------------------------------------------------------
vtkMakeFlattenable::~vtkMakeFlattenable() = default;

//------------------------------------------------------------------------------
void vtkMakeFlattenable::AddKeptCurve(const std::string& curve)
{
  if (this->KeptCurves.insert(curve).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::RemoveAllKeptCurves()
{
  if (flattening::bridge::changeToNone(this->KeptCurves))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::SetBodyConnection(vtkAlgorithmOutput* body)
{
  this->SetInputConnection(2, body);
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::SetBodyData(vtkPolyData* body)
{
  this->SetInputData(2, body);
}

//------------------------------------------------------------------------------
int vtkMakeFlattenable::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port < 2)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMakeFlattenable::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  namespace bridge = flattening::bridge;
  this->Begin(outputVector);
  const auto output = [outputVector](int port) { return vtkPolyData::GetData(outputVector, port); };
  flattening::FlattenableOptions options;
  options.bound = this->Bound;
  options.keepBoundary = this->KeepBoundary;
  options.outsideBias = this->OutsideBias;
  options.thickness = this->Thickness;
  options.flattening = this->Settings();
  const bridge::LoadedBody body = bridge::loadBody(vtkPolyData::GetData(inputVector[2]));
  options.body = body.get();
  const auto source = this->LoadInput(inputVector);
  if (source && this->Conclude(body.outcome) &&
    this->Conclude(
      source->pinVertices(this->GetConformalPins(), options.flattening.conformal.pins)) &&
    this->Conclude(bridge::findCurves(this->KeptCurves, *source, options.kept)))
  {
    this->Warn(bridge::describeShortEnds(*source));
    const flattening::FlattenableSurface result = flattening::makeFlattenable(
      source->imprinted.mesh, source->imprinted.curves, options, bridge::executionOf(this));
    if (this->Conclude(source->outcomeOfStage(
          result.status, result.status.refused() ? nullptr : result.after.cut.get())))
    {
      std::vector<std::string> warnings;
      if (!result.after.leftOut.empty())
      {
        warnings.push_back(bridge::describeLeftOut(*source, result.after));
      }
      if (!result.boundMet)
      {
        warnings.push_back(bridge::describeShortfall(result, options));
      }
      bridge::writeFlattenable(*source, result,
        { output(0), output(1), output(2), output(3), output(4), output(5) }, warnings);
      const std::string unit = this->LengthUnitOf(inputVector);
      bridge::writePieceSizes(bridge::pieceSizes(result.after), unit, output(0));
      bridge::writePieceSizes(bridge::pieceSizes(result.before), unit, output(5));
      this->Warn(warnings);
    }
  }
  this->WriteRunStatus(output(0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bound: " << this->Bound << "\n";
  os << indent << "KeepBoundary: " << (this->KeepBoundary ? "On" : "Off") << "\n";
  os << indent << "OutsideBias: " << this->OutsideBias << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  for (const std::string& curve : this->KeptCurves)
  {
    os << indent << "KeptCurve: " << curve << "\n";
  }
}
