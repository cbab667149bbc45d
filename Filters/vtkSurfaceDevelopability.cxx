// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceDevelopability.h"

#include "AttributeArrays.h"
#include "FilterExecution.h"
#include "Report/QualityReport.h"
#include "SurfaceInput.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSurfaceDevelopability);

//------------------------------------------------------------------------------
int vtkSurfaceDevelopability::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Begin(outputVector);
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const flattening::LoadedSurface surface =
    flattening::bridge::loadSurface(input, flattening::CoincidentPoints::Automatic,
      flattening::Defects::Heal, flattening::GhostCells::Duplicates);
  if (!this->Conclude(surface.outcome))
  {
    return 1;
  }
  const flattening::Column developability =
    flattening::developabilityOfPoints(surface, flattening::bridge::executionOf(this));
  output->ShallowCopy(input);
  std::vector<std::string> warnings = surface.mendings;
  output->GetPointData()->ShallowCopy(flattening::bridge::wholePointArrays(input, warnings));
  output->GetCellData()->ShallowCopy(flattening::bridge::wholeCellArrays(input, warnings));
  output->GetFieldData()->ShallowCopy(flattening::bridge::fieldArrays(input, warnings));
  this->Warn(warnings);
  flattening::bridge::addColumns(output->GetPointData(), { developability });
  return 1;
}
