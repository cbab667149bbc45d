// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveImprinter.h"

#include "SurfaceOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkFeatureCurveImprinter);

//------------------------------------------------------------------------------
vtkFeatureCurveImprinter::vtkFeatureCurveImprinter()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveImprinter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  vtkPolyData* surface = vtkPolyData::GetData(outputVector, 0);
  if (const auto source = this->LoadInput(inputVector))
  {
    std::vector<std::string> warnings;
    flattening::bridge::writeImprint(
      *source, surface, vtkPolyData::GetData(outputVector, 1), warnings);
    this->Warn(warnings);
  }
  this->WriteRunStatus(surface);
  return 1;
}
