// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceDevelopability.h"

#include "Status.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSurfaceDevelopability);

//------------------------------------------------------------------------------
int vtkSurfaceDevelopability::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData::GetData(outputVector)->ShallowCopy(vtkPolyData::GetData(inputVector[0]));
  return 1;
}
